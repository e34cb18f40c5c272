#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"

namespace aucast::speaker {

/// An expression that the text asks for, from a place on.
struct Cue {
  std::string name;    ///< as written
  std::size_t at = 0;  ///< characters of the text before it
  std::size_t line = 0;
  std::size_t column = 0;
};

/// What stands in a text file to be spoken: the words, and what is not spoken.
struct Script {
  std::string title;              ///< of a line "# title: ..."; empty: none
  std::string text;               ///< UTF-8, without cues and comments
  std::vector<Cue> cues;          ///< ascending
  std::vector<std::size_t> ends;  ///< characters of the text up to the end of each paragraph
};

/// Reads a text: paragraphs are parted by empty lines, a line that begins with # is a comment, a
/// word in brackets such as [smile] is a cue. `file` is what messages call it. BadData for bytes
/// that are no UTF-8, a bracket that is not closed on its line and a text without words.
[[nodiscard]] Result<Script> parse_script(std::string_view bytes, std::string_view file);

/// Characters (code points) of UTF-8.
[[nodiscard]] std::size_t characters(std::string_view utf8);

/// Where the characters of a text stand: found once, not by counting at every question.
class Characters {
 public:
  /// `utf8` must outlive it.
  explicit Characters(std::string_view utf8);
  [[nodiscard]] std::size_t count() const { return begins_.size() - 1; }
  /// The bytes of `count` characters from character `at` on, as far as there are any; views into
  /// the text.
  [[nodiscard]] std::string_view part(std::size_t at, std::size_t count) const;

 private:
  std::string_view utf8_;
  std::vector<std::size_t> begins_;  ///< the first byte of each, and the text's end
};

}  // namespace aucast::speaker
