// Any file: an error with a place, or a stream that is read again from its own text form.

#include "common/check.h"
#include "protocol/stream_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;
using namespace aucast::protocol;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto stream = parse_stream_file(fuzz::text_of(data, size), "f");
  if (!stream) {
    AUCAST_CHECK(stream.error().kind == ErrorKind::BadData);
    AUCAST_CHECK(stream.error().message.starts_with("f:"));
    return 0;
  }
  AUCAST_CHECK(!stream->keyframes.empty());
  const std::string text = format_stream_file(*stream);
  const auto again = parse_stream_file(text, "f");
  AUCAST_CHECK(again.has_value());
  AUCAST_CHECK(format_stream_file(*again) == text);
  AUCAST_CHECK(media_ms(*again, 250) == media_ms(*stream, 250));
  return 0;
}
