#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace aucast::sources {

/// What kind of text it is, by its first lines and not by its name.
enum class ContentKind : std::uint8_t {
  StreamFile,  ///< or something that will be refused as one
  Recording,   ///< a recogniser's table
  Unknown,     ///< a table or labels, but none that can be read
};
[[nodiscard]] ContentKind content_kind(std::string_view text);

/// The message about a text of an unknown kind: what it seems to be, and what is missing.
[[nodiscard]] std::string unknown_reason(std::string_view text);

/// The message about label files of DISFA, BP4D and CK+, which are numbers without names and times.
/// Recognised by at most three lines; nullopt for anything else.
[[nodiscard]] std::optional<std::string> label_file(std::string_view text);

}  // namespace aucast::sources
