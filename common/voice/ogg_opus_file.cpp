#include "common/voice/ogg_opus_file.h"

#include <ogg/ogg.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "common/check.h"

namespace aucast::voice {
namespace {

/// Granule positions count samples at 48 kHz whatever was encoded (RFC 7845 section 4).
constexpr std::int64_t kGranulesPerMs = 48;
constexpr std::int64_t kPageGranules = 1000 * kGranulesPerMs;
/// SILK wideband frames of 20 and 10 ms that have no bits say nothing: the decoder conceals into
/// silence.
constexpr std::string_view kSilence{"\x48", 1};
constexpr Milliseconds kSilenceTime{20};
constexpr std::string_view kShortSilence{"\x40", 1};
constexpr Milliseconds kShortSilenceTime{10};

std::string head() {
  constexpr char kVersion = 1;
  constexpr char kMono = 1;
  std::string bytes = "OpusHead";
  bytes += kVersion;
  bytes += kMono;
  bytes.append(2, '\0');                       // pre-skip: the encoder has taken its delay off
  bytes.append({'\x80', '\x3e', '\0', '\0'});  // 16000 Hz, what was encoded
  bytes.append(2, '\0');                       // gain
  bytes += '\0';                               // mapping family 0
  return bytes;
}

std::string tags() {
  constexpr std::string_view kVendor = "AUcast";
  std::string bytes = "OpusTags";
  bytes += static_cast<char>(kVendor.size());
  bytes.append(3, '\0');
  bytes += kVendor;
  bytes.append(4, '\0');
  return bytes;
}

}  // namespace

struct OggOpusWriter::State {
  State(Milliseconds from, std::uint32_t serial) : begin(from), end(from) {
    AUCAST_CHECK(ogg_stream_init(&stream, static_cast<int>(serial)) == 0);
    put(head(), 0, false);
    move_pages(true);
    put(tags(), 0, false);
    move_pages(true);
  }
  ~State() { ogg_stream_clear(&stream); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void put(std::string_view bytes, std::int64_t granules, bool last) {
    // libogg copies the bytes, but does not say so in its types.
    ogg_packet packet{};
    packet.packet = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));  // NOLINT
    packet.bytes = static_cast<long>(bytes.size());
    packet.b_o_s = number == 0 ? 1 : 0;
    packet.e_o_s = last ? 1 : 0;
    packet.granulepos = granules;
    packet.packetno = number++;
    AUCAST_CHECK(ogg_stream_packetin(&stream, &packet) == 0);
  }

  void put_sound(std::string_view bytes, Milliseconds until, bool last = false) {
    end = until;
    const std::int64_t granules = (end - begin).count() * kGranulesPerMs;
    put(bytes, granules, last);
    const bool second_full = granules - page_begin >= kPageGranules;
    if (second_full) page_begin = granules;
    move_pages(second_full || last);
  }

  void fill(Milliseconds until) {
    while (end + kSilenceTime <= until) put_sound(kSilence, end + kSilenceTime);
    if (end + kShortSilenceTime <= until) put_sound(kShortSilence, end + kShortSilenceTime);
  }

  void move_pages(bool flush) {
    ogg_page page{};
    while ((flush ? ogg_stream_flush(&stream, &page) : ogg_stream_pageout(&stream, &page)) != 0) {
      out.append(reinterpret_cast<const char*>(page.header),
                 static_cast<std::size_t>(page.header_len));
      out.append(reinterpret_cast<const char*>(page.body), static_cast<std::size_t>(page.body_len));
    }
  }

  ogg_stream_state stream{};
  std::int64_t number = 0;
  Milliseconds begin;
  Milliseconds end;
  std::int64_t page_begin = 0;
  std::string out;
};

OggOpusWriter::OggOpusWriter(Milliseconds begin, std::uint32_t serial)
    : state_(std::make_unique<State>(begin, serial)) {}
OggOpusWriter::~OggOpusWriter() = default;
OggOpusWriter::OggOpusWriter(OggOpusWriter&&) noexcept = default;
OggOpusWriter& OggOpusWriter::operator=(OggOpusWriter&&) noexcept = default;

std::string OggOpusWriter::take() {
  return std::exchange(state_->out, {});
}

bool OggOpusWriter::add(const protocol::VoicePacket& packet) {
  const auto time = protocol::opus_duration(packet.opus);
  if (!time || packet.place < state_->end) return false;
  state_->fill(packet.place);
  state_->put_sound(packet.opus, state_->end + *time);
  return true;
}

bool OggOpusWriter::any() const {
  return state_->end > state_->begin;
}

std::string OggOpusWriter::finish(Milliseconds end) {
  while (state_->end + kSilenceTime < end) {
    state_->put_sound(kSilence, state_->end + kSilenceTime);
  }
  // Players leave out what a last packet holds beyond its granule position (section 4.4).
  state_->put_sound(kSilence, std::max(end, state_->end), true);
  return take();
}

}  // namespace aucast::voice
