#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"

namespace aucast::speaker {

/// A cue: a place from which on the text asks for an expression.
struct Cue {
  std::string name;    ///< as written
  std::size_t at = 0;  ///< how many characters of the text come before it
  std::size_t line = 0;
  std::size_t column = 0;
};

/// The content of a text file to be spoken: the words, and what is not spoken.
struct Script {
  std::string title;  ///< from a line "# title: ..."; empty: none
  std::size_t title_line = 0;
  std::string text;               ///< UTF-8, without cues and comments
  std::vector<Cue> cues;          ///< in the order of the text
  std::vector<std::size_t> ends;  ///< of each paragraph: how many characters come before
                                  ///< its end
};

/// Reads a text, which messages call `file`: empty lines separate paragraphs, a line that begins
/// with # is a comment, a word in brackets such as [smile] is a cue. Fails with BadData for bytes
/// that are not UTF-8, control characters other than tabs and line ends, or a bracket that is
/// not closed on its line.
[[nodiscard]] Result<Script> parse_script(std::string_view bytes, std::string_view file);

/// The number of characters (code points).
[[nodiscard]] std::size_t characters(std::string_view utf8);

/// Finds parts of a text by character. The characters are counted only once, in the constructor.
class Characters {
 public:
  /// `utf8` must outlive this object.
  explicit Characters(std::string_view utf8);
  [[nodiscard]] std::size_t count() const { return begins_.size() - 1; }
  /// The bytes of `count` characters from character `at` on, or fewer at the end; a view into the
  /// text.
  [[nodiscard]] std::string_view part(std::size_t at, std::size_t count) const;

 private:
  std::string_view utf8_;
  std::vector<std::size_t> begins_;  ///< the first byte of each character, then the end of the text
};

}  // namespace aucast::speaker
