#include "common/manual.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace aucast {
namespace {

using Names = std::vector<std::string>;

// === --help
constexpr std::size_t kTextColumn = 27;  ///< where explanations begin, after shorter options

/// An option as it is typed, with its argument.
std::string tag_of(const OptionRow& row) {
  std::string tag = row.letter == 0 ? "" : std::string{'-', row.letter} + ", ";
  tag += typed_name(row);
  if (row.where != OptionRow::Where::Positional && !row.option.argument.empty())
    tag += " " + std::string(row.option.argument);
  return tag;
}

std::string help_line(const OptionRow& row) {
  std::string line = "  " + tag_of(row);
  line.resize(std::max(line.size() + 2, kTextColumn), ' ');
  return line + std::string(row.text) + "\n";
}

// === The manual page

/// Running text: backslashes and minus signs by name, no line that begins like a request.
std::string roff(std::string_view text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
    line_begins = c == '\n';
  }
  return out;
}

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

// === Completion

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string bash_completion(const std::string& name, const Names& options, const Names& commands) {
  std::string function = "_" + name;
  std::replace(function.begin(), function.end(), '-', '_');
  return "# bash completion for " + name + "\n" + function +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]}\n"
         "  COMPREPLY=()\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         joined(options) +
         "' -- \"$word\"))\n"
         "  elif [[ $COMP_CWORD -eq 1 ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '" +
         joined(commands) +
         "' -- \"$word\"; compgen -f -- \"$word\")\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -o default -F " +
         function + " " + name + "\n";
}

std::string zsh_completion(const std::string& name, const Names& options, const Names& commands) {
  return "#compdef " + name + "\n" +
         "if compset -P '--*='; then\n"
         "  _files\n"
         "elif [[ $PREFIX == -* ]]; then\n"
         "  compadd -- " +
         joined(options) +
         "\n"
         "else\n"
         "  (( CURRENT == 2 )) && compadd -- " +
         joined(commands) +
         "\n"
         "  _files\n"
         "fi\n";
}

std::string fish_completion(const std::string& name, const Names& options, const Names& commands) {
  const std::string begin = "complete -c " + name;
  std::string text = "# fish completion for " + name + "\n";
  for (const std::string& command : commands) {
    text += begin + " -n 'test (count (commandline -opc)) -eq 1' -a " + command + "\n";
  }
  for (const std::string& option : options) text += begin + " -l " + option.substr(2) + "\n";
  return text;
}

}  // namespace

std::string help_text(const CommandPage& page) {
  std::string text;
  for (const std::string_view line : page.usage) {
    text += (text.empty() ? "usage: " : "       ") + std::string(line) + "\n";
  }
  text += std::string(page.about);
  std::string options;
  std::string_view heading;
  for (const OptionRow& row : page.rows) {
    if (!row.heading.empty()) heading = row.heading;
    if (row.text.empty()) continue;
    if (!heading.empty()) options += "\n" + std::string(heading) + ":\n";
    heading = {};
    options += help_line(row);
  }
  text += (options.starts_with('\n') ? "" : "\n") + options;
  if (!page.notes.empty()) text += "\n" + std::string(page.notes);
  if (!page.examples.empty()) text += "\n";
  for (const std::string_view line : page.examples) text += "  " + std::string(line) + "\n";
  return text;
}

ManualPage::ManualPage(std::string_view program, std::string_view version, std::string_view says) {
  const std::string name(program);
  text_ = ".TH " + upper(program) + " 1 \"\" \"AUcast " + roff(version) + "\" \"AUcast\"\n";
  text_ += ".nh\n.ad l\n";
  section("NAME");
  text_ += roff(name) + " \\- " + roff(says) + "\n";
}

void ManualPage::section(std::string_view name) {
  text_ += ".SH " + roff(name) + "\n";
}

void ManualPage::heading(std::string_view name) {
  text_ += ".SS " + roff(name) + "\n";
}

void ManualPage::paragraph(std::string_view text) {
  text_ += ".PP\n" + roff(text) + "\n";
}

void ManualPage::item(std::string_view tag, std::string_view text) {
  text_ += ".TP\n\\fB" + roff(tag) + "\\fR\n" + (text.empty() ? "\\&" : roff(text)) + "\n";
}

void ManualPage::example(std::string_view line) {
  text_ += ".PP\n.nf\n.RS\n" + roff(line) + "\n.RE\n.fi\n";
}

void ManualPage::options(const std::vector<OptionRow>& rows) {
  for (const OptionRow& row : rows) {
    if (!row.heading.empty()) heading(row.heading);
    std::string text(row.more.empty() ? row.text : row.more);
    if (!row.option.fallback.empty()) {
      if (!text.empty()) text += text.back() == '.' ? " " : ". ";
      text += "Default: " + std::string(row.option.fallback) + ".";
    }
    item(tag_of(row), text);
  }
}

void ManualPage::command(const CommandPage& page) {
  for (const std::string_view line : page.usage) example(line);
  paragraph(page.about);
  options(page.rows);
  std::string_view notes = page.notes;
  while (!notes.empty()) {
    const std::size_t end = notes.find("\n\n");
    paragraph(notes.substr(0, end));
    notes.remove_prefix(end == std::string_view::npos ? notes.size() : end + 2);
  }
  for (const std::string_view line : page.examples) example(line);
}

std::optional<std::string> asked_completion(const std::vector<std::string>& arguments,
                                            const std::vector<CommandPage>& pages) {
  if (arguments.empty() || arguments.size() > 2 || arguments[0] != "--help-completion") {
    return std::nullopt;
  }
  const std::string shell = arguments.size() == 2 ? arguments[1] : "bash";
  const std::string program(pages.front().program);
  std::set<std::string> options;
  Names commands;
  for (const CommandPage& page : pages) {
    if (!page.command.empty()) commands.emplace_back(page.command);
    for (const OptionRow& row : page.rows) {
      if (row.where != OptionRow::Where::Positional) options.insert(typed_name(row));
    }
  }
  const Names names(options.begin(), options.end());
  if (shell == "bash") return bash_completion(program, names, commands);
  if (shell == "zsh") return zsh_completion(program, names, commands);
  if (shell == "fish") return fish_completion(program, names, commands);
  return std::nullopt;
}

}  // namespace aucast
