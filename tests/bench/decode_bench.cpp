// How fast packets are cut and read, beside a straightforward reader of the same packets: take the
// text up to each closing brace and read numbers from a string stream.

#include <chrono>
#include <cstdio>
#include <sstream>
#include <string>

#include "protocol/codec.h"
#include "protocol/decoder.h"

namespace {

using aucast::protocol::Keyframe;
using aucast::protocol::ServerPacketDecoder;

constexpr int kPackets = 200'000;
constexpr std::size_t kPortion = 1460;  // what one TCP segment brings

std::string expressions() {
  const char* const packets[] = {"{1,2,5,15,16,20,26}", "{1,2,4,5,15,20,26}", "{2,4,9,15,17}",
                                 "{2,4,7,9,10,20,26}",  "{1,6,12,14}",        "{1,4,15,23}"};
  std::string bytes;
  for (int i = 0; i < kPackets; ++i) bytes += packets[i % 6];
  return bytes;
}

long sum_by_decoder(const std::string& bytes) {
  ServerPacketDecoder decoder;
  long sum = 0;
  for (std::size_t at = 0; at < bytes.size(); at += kPortion) {
    std::string_view portion = std::string_view(bytes).substr(at, kPortion);
    while (const auto packet = decoder.next(portion)) {
      for (const auto& term : std::get<Keyframe>(*packet).terms) sum += term.number;
    }
  }
  return sum;
}

long sum_by_string_stream(const std::string& bytes) {
  long sum = 0;
  std::string pending;
  for (std::size_t at = 0; at < bytes.size(); at += kPortion) {
    pending += bytes.substr(at, kPortion);
    for (std::size_t end = pending.find('}'); end != std::string::npos; end = pending.find('}')) {
      std::istringstream inside(pending.substr(1, end - 1));
      std::string number;
      while (std::getline(inside, number, ',')) sum += std::stoi(number);
      pending.erase(0, end + 1);
    }
  }
  return sum;
}

template <typename Work>
double seconds(const Work& work, long& sum) {
  const auto begin = std::chrono::steady_clock::now();
  sum = work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main() {
  const std::string bytes = expressions();
  long ours = 0;
  long naive = 0;
  double ours_s = 1e9;
  double naive_s = 1e9;
  for (int round = 0; round < 5; ++round) {  // interleaved; the best of each
    ours_s = std::min(ours_s, seconds([&] { return sum_by_decoder(bytes); }, ours));
    naive_s = std::min(naive_s, seconds([&] { return sum_by_string_stream(bytes); }, naive));
  }
  if (ours != naive) {
    std::fprintf(stderr, "the two readers disagree: %ld and %ld\n", ours, naive);
    return 1;
  }
  std::printf(
      "decode: %.2f million packets/s, %.0f MB/s; a string-stream reader takes %.1f times as "
      "long\n",
      kPackets / ours_s / 1e6, static_cast<double>(bytes.size()) / ours_s / 1e6, naive_s / ours_s);
  return 0;
}
