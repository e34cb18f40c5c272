// Any table: an error with the file's name, or a stream that a stream file can hold.

#include "common/check.h"
#include "common/sources/content.h"
#include "common/sources/found_report.h"
#include "common/sources/recording.h"
#include "protocol/limits.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/support/read_recording.h"

using namespace aucast;
using namespace aucast::sources;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  static_cast<void>(content_kind(text));
  static const ArkitTable kCurves = {{{"jawOpen", 26, Side::Both, 1},
                                      {"eyeBlinkLeft", 45, Side::Left, 1},
                                      {"eyeLookUpLeft", 63, Side::Left, 1}}};
  RecordingOptions options;
  // The first byte of the text decides nothing in a table: a blank before it is trimmed.
  if (text.starts_with(' ')) options.fps = 30;
  const auto recording =
      read_recording(text, "f", options, {}, [] { return Result<ArkitTable>(kCurves); });
  if (!recording) {
    AUCAST_CHECK(recording.error().message.starts_with("f:"));
    return 0;
  }
  AUCAST_CHECK(!recording->stream.keyframes.empty());
  for (const auto& keyframe : recording->stream.keyframes) {
    const std::int64_t time_ms = keyframe.time_ms.value_or(1);
    AUCAST_CHECK(time_ms >= 1 && time_ms <= protocol::kKeyframeTimeMsMax);
  }
  const auto again =
      protocol::parse_stream_file(protocol::format_stream_file(recording->stream), "f");
  AUCAST_CHECK(again.has_value());
  AUCAST_CHECK(protocol::media_ms(*again, 250) == protocol::media_ms(recording->stream, 250));
  AUCAST_CHECK(!found_lines(recording->found).empty());
  return 0;
}
