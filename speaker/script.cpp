#include "speaker/script.h"

#include <algorithm>

#include "common/text.h"
#include "common/text_file.h"

namespace aucast::speaker {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/// Refuses bytes that are not UTF-8, and control characters: espeak-ng ends a text at a NUL.
Result<void> check_characters(std::string_view bytes, std::string_view file) {
  std::size_t line = 1;
  std::size_t line_begin = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto wrong = [&](const std::string& text) {
      return Error{ErrorKind::BadData, at_place(file, line, at - line_begin + 1, text)};
    };
    const std::size_t length = utf8_length(bytes.substr(at));
    if (length == 0) return wrong("a byte that is no UTF-8; convert the text to UTF-8");
    const std::string_view character = bytes.substr(at, length);
    if (character != "\n" && is_control(character) &&
        kBlanks.find(character) == std::string_view::npos) {
      return wrong("a control character (" + escaped(character) +
                   "), which cannot be spoken; delete it");
    }
    at += length;
    if (character != "\n") continue;
    ++line;
    line_begin = at;
  }
  return {};
}

class Reader {
 public:
  explicit Reader(std::string_view file) : file_(file) {}

  [[nodiscard]] Result<void> take_line(std::string_view line) {
    ++line_;
    const std::string_view content = trimmed(line, kBlanks);
    if (content.empty()) {
      end_paragraph();
    } else if (content.front() == '#') {
      take_comment(trimmed(content.substr(1), kBlanks));
    } else {
      return take_words(line);
    }
    return {};
  }

  [[nodiscard]] Script finish() {
    end_paragraph();
    return std::move(script_);
  }

 private:
  void take_comment(std::string_view comment) {
    constexpr std::string_view kTitle = "title:";
    if (lowered(comment).starts_with(kTitle)) {
      script_.title = trimmed(comment.substr(kTitle.size()), kBlanks);
      script_.title_line = line_;
    }
  }

  Result<void> take_words(std::string_view line) {
    if (!script_.text.empty() && script_.text.back() != '\n') script_.text += ' ';
    while (!line.empty()) {
      const std::size_t open = line.find('[');
      append(line.substr(0, open));
      if (open == std::string_view::npos) break;
      const std::size_t close = line.find(']', open);
      if (close == std::string_view::npos) {
        return Error{ErrorKind::BadData,
                     at_place(file_, line_, column_, "a [ without its ] on the same line")};
      }
      const std::string_view name = trimmed(line.substr(open + 1, close - open - 1), kBlanks);
      script_.cues.push_back({std::string(name), characters_so_far(), line_, column_});
      column_ += close - open + 1;
      line.remove_prefix(close + 1);
    }
    column_ = 1;
    return {};
  }

  void append(std::string_view words) {
    column_ += words.size();
    const bool after_word =
        !script_.text.empty() && script_.text.back() != '\n' && script_.text.back() != ' ';
    // A blank between two cues is one between words, but cues alone are no words.
    if (after_word || !trimmed(words, kBlanks).empty()) script_.text += words;
    while (!script_.text.empty() && (script_.text.back() == '\r')) script_.text.pop_back();
  }

  void end_paragraph() {
    if (script_.text.empty() || script_.text.back() == '\n') return;
    script_.text += "\n\n";  // espeak-ng ends a sentence there
    script_.ends.push_back(characters_so_far());
  }

  /// Of the script's text; each is counted once. Only white space is ever taken back from it, and
  /// never what was counted.
  std::size_t characters_so_far() {
    count_ += characters(std::string_view(script_.text).substr(counted_));
    counted_ = script_.text.size();
    return count_;
  }

  std::string_view file_;
  std::size_t line_ = 0;
  std::size_t column_ = 1;
  Script script_;
  std::size_t counted_ = 0;  ///< bytes of its text
  std::size_t count_ = 0;    ///< characters in them
};

}  // namespace

std::size_t characters(std::string_view utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char byte) { return !is_continuation(byte); }));
}

Characters::Characters(std::string_view utf8) : utf8_(utf8) {
  for (std::size_t byte = 0; byte < utf8.size(); ++byte) {
    if (!is_continuation(utf8[byte])) begins_.push_back(byte);
  }
  begins_.push_back(utf8.size());
}

std::string_view Characters::part(std::size_t at, std::size_t count) const {
  const std::size_t first = std::min(at, this->count());
  const std::size_t last = first + std::min(count, this->count() - first);
  return utf8_.substr(begins_[first], begins_[last] - begins_[first]);
}

Result<Script> parse_script(std::string_view bytes, std::string_view file) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (auto good = check_characters(bytes, file); !good) return good.error();
  Reader reader(file);
  for (const std::string_view line : split(bytes, '\n')) {
    if (auto taken = reader.take_line(line); !taken) return taken.error();
  }
  return reader.finish();
}

}  // namespace aucast::speaker
