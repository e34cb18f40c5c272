// A hostile server that a stream is brought to: the input is its answer, whole and cut into pieces.

#include "common/check.h"
#include "protocol/limits.h"
#include "protocol/publish_session.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;
using namespace aucast::protocol;

namespace {

PublishSession::Answer answer_in_pieces(std::string_view bytes, std::size_t size) {
  PublishSession session({"talk", "word", "id"});
  PublishSession::Answer answer;
  for (; !bytes.empty() && answer.index() == 0; bytes.remove_prefix(std::min(size, bytes.size()))) {
    answer = session.on_bytes(bytes.substr(0, size));
  }
  return answer;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text_of(data, size);
  const auto whole = answer_in_pieces(bytes, size);
  const auto cut = answer_in_pieces(bytes, 1);
  AUCAST_CHECK(whole.index() == cut.index());
  if (const auto* failed = std::get_if<PublishSession::Failed>(&whole)) {
    AUCAST_CHECK(failed->reason == std::get<PublishSession::Failed>(cut).reason);
    AUCAST_CHECK(!failed->reason.empty());
  } else if (const auto* taken = std::get_if<PublishSession::Taken>(&whole)) {
    AUCAST_CHECK(taken->bytes == bytes);
    AUCAST_CHECK(bytes.starts_with(std::get<PublishSession::Taken>(cut).bytes));
  }
  return 0;
}
