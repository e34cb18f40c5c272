#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aucast {

/// Bytes from outside made safe for a terminal or a log: printable ASCII as it is, everything else
/// as \xNN, cut to `length_max` with "..." when longer.
[[nodiscard]] std::string escaped(std::string_view bytes, std::size_t length_max = 60);

/// The known word nearest to `word` by edits, when it is near enough to be meant; for "did you
/// mean".
[[nodiscard]] std::optional<std::string> nearest(std::string_view word,
                                                 const std::vector<std::string>& known);

/// The parts between separators, as many as there are of these and one; they may be empty. They are
/// views into `text`.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// "1 packet", "6 packets".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view thing);

/// Shortest text that is read back as the same number.
[[nodiscard]] std::string number_text(double value);

/// What the system says of an errno: "No such file or directory".
[[nodiscard]] std::string system_reason(int error_number);

/// "file:line:column: text"; line and column count from 1 and 0 leaves them out.
[[nodiscard]] std::string at_place(std::string_view file, std::size_t line, std::size_t column,
                                   std::string_view text);

}  // namespace aucast
