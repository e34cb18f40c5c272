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
  std::string title{};              ///< as from stream_title()
};

/// Takes the keyframes of a stream file one by one; an error ends the reading.
using KeyframeSink = std::function<Result<void>(Keyframe&& keyframe)>;

/// Reads the text of a stream file and passes its keyframes to `sink`; keeps none of them. Errors
/// are those of parse_stream_file(), or the sink's. Keyframes before an error have been passed on.
[[nodiscard]] Result<void> read_stream_file(std::string_view text, std::string_view file,
                                            const KeyframeSink& sink);

struct StreamTitle {
  std::string text;      ///< byte for byte as in the file; not checked by is_title()
  std::size_t line = 0;  ///< where it is
};

/// The title from a comment "# title: ..." before the first packet; empty: there is none.
[[nodiscard]] StreamTitle stream_title(std::string_view text);

/// Why no client gets this title, with its line in the stream file, which messages call `file`.
/// Empty: clients get it, or there is no title.
[[nodiscard]] std::string title_complaint(const StreamTitle& title, std::string_view file);

/// Reads the whole text of a stream file, which messages call `file`. Fails with BadData and one
/// line "file:line:column: reason" for each of the first kReportedErrorsMax errors, and a last line
/// that counts the rest. When asked to stop, fails with stopped_early() at the next keyframe.
[[nodiscard]] Result<StreamFile> parse_stream_file(std::string_view text, std::string_view file,
                                                   const StopToken& stop = {});

/// Reads one line between the tags, without blanks around it and without a comment: a keyframe with
/// or without braces. Returns nullopt on success, with the keyframe in `out`.
[[nodiscard]] std::optional<TextError> parse_stream_line(std::string_view content, Keyframe& out);

/// A stream file that was cut off, made readable again.
struct MendedText {
  std::string text;
  std::size_t lines_left_out = 0;  ///< the broken line and all after it
};

/// Keeps everything before the first line that is incomplete or cannot be read, and adds
/// End_Stream. Other errors are left to parse_stream_file().
[[nodiscard]] MendedText mend_stream_text(std::string_view text);

/// The keyframe as a line: its canonical packet without braces, without a line end.
[[nodiscard]] std::string format_stream_line(const Keyframe& keyframe);

/// The whole file as text: the title if there is one, the tags, and between them
/// format_stream_line() of each keyframe.
[[nodiscard]] std::string format_stream_file(const StreamFile& stream);

/// Sum of the keyframes' times in ms, untimed ones counted as `keyframe_ms`.
[[nodiscard]] std::uint64_t media_ms(const StreamFile& stream, std::uint32_t keyframe_ms);

}  // namespace aucast::protocol
