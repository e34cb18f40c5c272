#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aucast {

/// A manual page in roff, section by section. Texts are plain: what is special to roff is escaped
/// here.
class ManualPage {
 public:
  /// `says`: the program in half a sentence, for whatis(1).
  ManualPage(std::string_view program, std::string_view version, std::string_view says);

  void section(std::string_view name);
  void heading(std::string_view name);  ///< within a section
  void paragraph(std::string_view text);
  /// An option or a file, and what it is.
  void item(std::string_view tag, std::string_view text);
  /// A line as it is typed.
  void example(std::string_view line);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Adds a page of --help as our programs write them: lines without indent are headings or text,
/// those indented by two are options with their explanation behind two blanks or more, or command
/// lines of `program`; what is indented further goes on.
void add_help_page(ManualPage& page, std::string_view program, std::string_view help);

/// The options (--name) that a text mentions, sorted, each once.
[[nodiscard]] std::vector<std::string> options_in(std::string_view text);

/// What makes bash complete the program's options and, where they may stand, its commands; other
/// words are files.
[[nodiscard]] std::string bash_completion(std::string_view program,
                                          const std::vector<std::string>& options,
                                          const std::vector<std::string>& commands);
/// The same for zsh and for fish.
[[nodiscard]] std::string zsh_completion(std::string_view program,
                                         const std::vector<std::string>& options,
                                         const std::vector<std::string>& commands);
[[nodiscard]] std::string fish_completion(std::string_view program,
                                          const std::vector<std::string>& options,
                                          const std::vector<std::string>& commands);

/// What `PROGRAM --help-completion [bash|zsh|fish]` prints; nothing when that was not asked for, or
/// for another shell.
[[nodiscard]] std::optional<std::string> asked_completion(const std::vector<std::string>& arguments,
                                                          std::string_view program,
                                                          const std::vector<std::string>& options,
                                                          const std::vector<std::string>& commands);

}  // namespace aucast
