#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace aucast::sources {

/// The kind of a file, as its first lines show it, whatever its name is.
enum class ContentKind : std::uint8_t {
  StreamFile,  ///< a stream file, or text that will be refused as a faulty one
  Recording,   ///< a recogniser's table
  Unknown,     ///< a table or label file, but of a kind that cannot be read
};
[[nodiscard]] ContentKind content_kind(std::string_view text);

/// The message about a text of kind Unknown: what it seems to be, and what is missing.
[[nodiscard]] std::string unknown_reason(std::string_view text);

/// The message about a label file of DISFA, BP4D or CK+, which has numbers but neither names nor
/// times; nullopt when the text is no such file. Looks at the first three lines at most.
[[nodiscard]] std::optional<std::string> label_file(std::string_view text);

}  // namespace aucast::sources
