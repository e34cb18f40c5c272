#include "common/manual.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace aucast {
namespace {

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

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

/// The parts of a line that two blanks or more set apart.
std::vector<std::string> columns(std::string_view line) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string_view::npos) return parts;
    line.remove_prefix(begin);
    const std::size_t end = line.find("  ");
    parts.emplace_back(line.substr(0, end));
    if (end == std::string_view::npos) return parts;
    line.remove_prefix(end);
  }
}

/// Options of a help page, gathered until their explanation is complete.
class Items {
 public:
  explicit Items(ManualPage& page) : page_(page) {}

  void add_line(std::string_view line) {
    for (const std::string& part : columns(line)) {
      if (part.starts_with('-')) {
        flush();
        tag_ = part;
      } else {
        text_ += (text_.empty() ? "" : " ") + part;
      }
    }
  }

  void flush() {
    if (!tag_.empty()) page_.item(tag_, text_);
    tag_.clear();
    text_.clear();
  }

  [[nodiscard]] bool open() const { return !tag_.empty(); }

 private:
  ManualPage& page_;
  std::string tag_;
  std::string text_;
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace

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

void add_help_page(ManualPage& page, std::string_view program, std::string_view help) {
  Items items(page);
  std::string running;  // text that goes on in the next line
  const auto end_paragraph = [&] {
    items.flush();
    if (!running.empty()) page.paragraph(running);
    running.clear();
  };
  const std::vector<std::string> lines = lines_of(help);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) {
      end_paragraph();
    } else if (indent == 0) {
      items.flush();
      const bool heads = i + 1 < lines.size() && lines[i + 1].starts_with("  -");
      if (heads && running.empty()) {
        page.heading(line);
      } else {
        running += (running.empty() ? "" : " ") + line;
      }
    } else if (line.compare(indent, program.size(), program) == 0) {
      end_paragraph();
      page.example(line.substr(indent));
    } else {
      if (!running.empty()) end_paragraph();
      if (line[indent] == '-' || items.open()) {
        items.add_line(line);
      } else {
        page.example(line.substr(indent));
      }
    }
  }
  end_paragraph();
}

std::vector<std::string> options_in(std::string_view text) {
  std::set<std::string> options;
  for (std::size_t at = text.find("--"); at != std::string_view::npos; at = text.find("--", at)) {
    std::size_t end = at + 2;
    while (end < text.size() &&
           (std::islower(static_cast<unsigned char>(text[end])) != 0 || text[end] == '-')) {
      ++end;
    }
    if (end > at + 2 && text[at + 2] != '-') options.emplace(text.substr(at, end - at));
    at = end;
  }
  return {options.begin(), options.end()};
}

std::string bash_completion(std::string_view program, const std::vector<std::string>& options,
                            const std::vector<std::string>& commands) {
  const std::string name(program);
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

std::string zsh_completion(std::string_view program, const std::vector<std::string>& options,
                           const std::vector<std::string>& commands) {
  const std::string name(program);
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

std::string fish_completion(std::string_view program, const std::vector<std::string>& options,
                            const std::vector<std::string>& commands) {
  const std::string name(program);
  const std::string begin = "complete -c " + name;
  std::string text = "# fish completion for " + name + "\n";
  for (const std::string& command : commands) {
    text += begin + " -n 'test (count (commandline -opc)) -eq 1' -a " + command + "\n";
  }
  for (const std::string& option : options) text += begin + " -l " + option.substr(2) + "\n";
  return text;
}

std::optional<std::string> asked_completion(const std::vector<std::string>& arguments,
                                            std::string_view program,
                                            const std::vector<std::string>& options,
                                            const std::vector<std::string>& commands) {
  if (arguments.empty() || arguments.size() > 2 || arguments[0] != "--help-completion") {
    return std::nullopt;
  }
  const std::string shell = arguments.size() == 2 ? arguments[1] : "bash";
  if (shell == "bash") return bash_completion(program, options, commands);
  if (shell == "zsh") return zsh_completion(program, options, commands);
  if (shell == "fish") return fish_completion(program, options, commands);
  return std::nullopt;
}

}  // namespace aucast
