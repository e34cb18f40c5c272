#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "common/stopped.h"
#include "protocol/codec.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// The lines before and after a stream.
inline constexpr std::string_view kBeginTag = "Beg_Stream";
inline constexpr std::string_view kEndTag = "End_Stream";

/// A stream file in memory: the keyframes between Beg_Stream and End_Stream, in order.
struct StreamFile {
  std::vector<Keyframe> keyframes;  ///< at least one; none is changes-only
};

/// Takes the keyframes of a stream file one by one; an error ends the reading.
using KeyframeSink = std::function<Result<void>(Keyframe&& keyframe)>;

/// Reads the text of a stream file and hands its keyframes to `sink`; keeps none of them. Errors as
/// of parse_stream_file(), or the sink's. Keyframes before an error were handed out.
[[nodiscard]] Result<void> read_stream_file(std::string_view text, std::string_view file,
                                            const KeyframeSink& sink);

/// What a comment "# title: ..." before the first packet says; empty: there is none. Bytes as they
/// are in the file.
[[nodiscard]] std::string stream_title(std::string_view text);

/// Reads the text of a stream file whole. `file` is what messages call it. BadData with one line
/// "file:line:column: reason" per error, the first kReportedErrorsMax of them, and a last line that
/// counts the rest. Asked to stop, it returns stopped_early() at the next keyframe.
[[nodiscard]] Result<StreamFile> parse_stream_file(std::string_view text, std::string_view file,
                                                   const StopToken& stop = {});

/// Reads one line between the tags, without blanks around it and without a comment: a keyframe with
/// or without braces. On success it is in `out` and nothing is returned.
[[nodiscard]] std::optional<TextError> parse_stream_line(std::string_view content, Keyframe& out);

/// A stream file that was cut off, made whole again.
struct MendedText {
  std::string text;
  std::size_t lines_left_out = 0;  ///< from the first one on that is torn
};

/// Everything before the first line that is no whole line of a stream file, and End_Stream. What
/// else is wrong is left to parse_stream_file().
[[nodiscard]] MendedText mend_stream_text(std::string_view text);

/// One canonical packet as a line, without braces and without the line's end.
[[nodiscard]] std::string format_stream_line(const Keyframe& keyframe);

/// The same as text: tags, one canonical packet per line without braces.
[[nodiscard]] std::string format_stream_file(const StreamFile& stream);

/// Sum of the keyframes' times in ms, untimed ones counted as `keyframe_ms`.
[[nodiscard]] std::uint64_t media_ms(const StreamFile& stream, std::uint32_t keyframe_ms);

}  // namespace aucast::protocol
