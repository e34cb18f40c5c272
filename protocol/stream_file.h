#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "protocol/codec.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// A stream file in memory: the keyframes between Beg_Stream and End_Stream, in order.
struct StreamFile {
  std::vector<Keyframe> keyframes;  ///< at least one; none is changes-only
};

/// Reads the text of a stream file whole. `file` is what messages call it. BadData with one line
/// "file:line:column: reason" per error, the first kReportedErrorsMax of them, and a last line that
/// counts the rest.
[[nodiscard]] Result<StreamFile> parse_stream_file(std::string_view text, std::string_view file);

/// Reads one line between the tags, without blanks around it and without a comment: a keyframe with
/// or without braces. On success it is in `out` and nothing is returned.
[[nodiscard]] std::optional<TextError> parse_stream_line(std::string_view content, Keyframe& out);

/// The same as text: tags, one canonical packet per line without braces.
[[nodiscard]] std::string format_stream_file(const StreamFile& stream);

/// Sum of the keyframes' times in ms, untimed ones counted as `keyframe_ms`.
[[nodiscard]] std::uint64_t media_ms(const StreamFile& stream, std::uint32_t keyframe_ms);

}  // namespace aucast::protocol
