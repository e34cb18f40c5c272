#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/options.h"

namespace aucast {

/// The help of a program, or of one of its commands.
struct CommandPage {
  std::string_view program;                     ///< "face-player"
  std::string_view command = {};                ///< "play"; empty: the program without a command
  std::vector<std::string_view> usage = {};     ///< lines as they are typed
  std::string_view about = {};                  ///< lines of running text
  std::vector<OptionRow> rows = {};             ///< only their names and texts are used
  std::string_view notes = {};                  ///< paragraphs after the options
  std::vector<std::string_view> examples = {};  ///< lines as they are typed
};

/// The text of --help, at most 80 columns wide unless a text of the page is wider. Options without
/// a `text` are left to the manual page.
[[nodiscard]] std::string help_text(const CommandPage& page);

/// Writes a manual page in roff, section by section. Give it plain text; it escapes what is special
/// to roff.
class ManualPage {
 public:
  /// `says`: what the program does, in half a sentence, for whatis(1).
  ManualPage(std::string_view program, std::string_view version, std::string_view says);

  void section(std::string_view name);
  void heading(std::string_view name);  ///< within a section
  void paragraph(std::string_view text);
  /// An option or a file, with its explanation.
  void item(std::string_view tag, std::string_view text);
  /// A line as it is typed.
  void example(std::string_view line);

  /// The options of a command with their whole explanations.
  void options(const std::vector<OptionRow>& rows);
  /// The whole page of a command, within a section.
  void command(const CommandPage& page);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// What `PROGRAM --help-completion [bash|zsh|fish]` prints: a script that makes the shell complete
/// the options of all pages and the names of commands; other words are completed as files. nullopt
/// when the arguments do not ask for that, or name another shell.
[[nodiscard]] std::optional<std::string> asked_completion(const std::vector<std::string>& arguments,
                                                          const std::vector<CommandPage>& pages);

}  // namespace aucast
