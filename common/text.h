#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "common/time.h"

namespace aucast {

/// Makes bytes of a peer or a file safe for a terminal or a log: printable ASCII as it is,
/// everything else as \xNN, cut to `length_max` with "..." when longer.
[[nodiscard]] std::string escaped(std::string_view bytes, std::size_t length_max = 60);

[[nodiscard]] constexpr std::uint8_t byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

/// Whether the byte belongs to a UTF-8 character but is not its first.
[[nodiscard]] constexpr bool is_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// The length of the UTF-8 character that `bytes` begins with; 0 when there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view bytes);

/// Whether the UTF-8 character is one of the control characters C0, DEL or C1.
[[nodiscard]] bool is_control(std::string_view character);

/// Makes a path or a person's text safe for a terminal or a log: UTF-8 as it is, control characters
/// and invalid UTF-8 as \xNN.
[[nodiscard]] std::string printable(std::string_view bytes);

/// The known word that becomes `word` with the fewest edits; nullopt if even these are too many.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word,
                                                 const std::vector<std::string>& known);

/// "; did you mean X?" with the nearest() word; empty when there is none.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& known);

/// The parts between separators, some perhaps empty: one more than there are separators. Views into
/// `text`.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// The parts between blanks, tabs and carriage returns, none of them empty. Views into `text`.
[[nodiscard]] std::vector<std::string_view> split_words(std::string_view text);

/// The text with ASCII capitals in lower case, every other byte as it is.
[[nodiscard]] std::string lowered(std::string_view text);

/// What a file's name ends in, with its dot, in lower case: ".mp4" for A.MP4. Empty: it has none.
[[nodiscard]] std::string file_ending(const std::filesystem::path& file);

/// "1 packet", "6 packets".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view thing);

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string number_text(double value);

/// A length as clocks show it, to the nearest second: "0:07", "1:23", "1:02:03". Only a length of
/// 0 is "0:00". `length`: 0 or more.
[[nodiscard]] std::string length_text(Milliseconds length);

/// The message of an errno: "No such file or directory".
[[nodiscard]] std::string system_reason(int error_number);

/// For a message when the system refused a thread, timer or socket: the cause and what to look at,
/// "Resource temporarily unavailable; the system is short of threads or files".
[[nodiscard]] std::string shortage_text(const std::system_error& failure);

/// "file:line:column: text" with the file's name printable(); line and column count from 1; one
/// that is 0 is left out. Every message about a file begins in this way.
[[nodiscard]] std::string at_place(std::string_view file, std::size_t line, std::size_t column,
                                   std::string_view text);

/// "file: text", likewise.
[[nodiscard]] std::string at_place(std::string_view file, std::string_view text);

}  // namespace aucast
