#include "speaker/captions.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

namespace aucast::speaker {
namespace {

constexpr std::size_t kLineMax = 42;
constexpr std::size_t kCaptionMax = 2 * kLineMax;
constexpr Milliseconds kGapMax{900};
constexpr std::string_view kWhiteSpace = " \t\r\n";

/// The word as it is written, with the marks that follow it.
std::string written(const Characters& script, const std::vector<Word>& words, std::size_t i) {
  const std::size_t from = words[i].at;
  const std::size_t next = i + 1 < words.size() ? words[i + 1].at : script.count();
  const std::size_t to = std::max(from + words[i].length, next);
  // An empty line would end a caption.
  std::string text;
  bool blank = false;
  for (const char c : script.part(from, to - from)) {
    if (kWhiteSpace.find(c) != std::string_view::npos) {
      blank = !text.empty();
      continue;
    }
    if (std::exchange(blank, false)) text += ' ';
    text += c;
  }
  return text;
}

bool ends_sentence(const std::string& text) {
  return !text.empty() && std::string_view(".?!").find(text.back()) != std::string_view::npos;
}

/// Breaks the text into two lines, near the middle, if it is too long for one.
std::string in_lines(std::string text) {
  if (characters(text) <= kLineMax) return text;
  std::size_t best = std::string::npos;
  const auto distance = [&](std::size_t at) {
    return at > text.size() / 2 ? at - text.size() / 2 : text.size() / 2 - at;
  };
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    if (best == std::string::npos || distance(at) < distance(best)) best = at;
  }
  if (best != std::string::npos) text[best] = '\n';
  return text;
}

std::string clock(Milliseconds time) {
  const auto ms = static_cast<long>(time.count());
  char text[32];
  std::snprintf(text, sizeof text, "%02ld:%02ld:%02ld.%03ld", ms / 3600000, ms / 60000 % 60,
                ms / 1000 % 60, ms % 1000);
  return text;
}

/// A text that WebVTT would read as markup, or as the times of the next caption, as it is.
std::string escaped_for_webvtt(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::vector<TimedCaption> captions_of(const Speech& speech, const Script& script) {
  const Characters characters_of_script(script.text);
  std::vector<TimedCaption> captions;
  bool fresh = true;
  for (std::size_t i = 0; i < speech.words.size(); ++i) {
    const Word& word = speech.words[i];
    if (word.length == 0) continue;
    const std::string text = written(characters_of_script, speech.words, i);
    if (text.empty()) continue;
    const bool gap = !captions.empty() && word.begin - captions.back().end > kGapMax;
    const bool full =
        !captions.empty() && characters(captions.back().text) + 1 + characters(text) > kCaptionMax;
    if (fresh || gap || full) {
      captions.push_back({word.begin, word.begin, text});
    } else {
      captions.back().text += ' ' + text;
    }
    const Milliseconds next =
        i + 1 < speech.words.size() ? speech.words[i + 1].begin : speech.length();
    captions.back().end = std::min(next, word.begin + Milliseconds(1500));
    fresh = ends_sentence(text);
  }
  for (TimedCaption& caption : captions) caption.text = in_lines(std::move(caption.text));
  return captions;
}

std::string format_webvtt(const std::vector<TimedCaption>& captions) {
  std::string file = "WEBVTT\n";
  for (const TimedCaption& caption : captions) {
    file += "\n" + clock(caption.begin) + " --> " + clock(caption.end) + "\n" +
            escaped_for_webvtt(caption.text) + "\n";
  }
  return file;
}

}  // namespace aucast::speaker
