#include "speaker/captions.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <span>
#include <string_view>

#include "common/text.h"
#include "protocol/caption.h"

namespace aucast::speaker {
namespace {

constexpr std::size_t kLineMax = 42;
constexpr Milliseconds kGapMax{900};
constexpr Milliseconds kWordMax{1500};  ///< a caption stays no longer after the last word begins
constexpr std::string_view kWhiteSpace = " \t\r\n";

/// What stands in one line: what is written between two blanks, or one character of a script that
/// has no blanks between words.
struct Piece {
  std::string text;
  bool after_blank = false;
  bool spoken = false;  ///< else marks alone
  Milliseconds begin{0};
  Milliseconds end{0};  ///< of its last word, if it is spoken
};
using Pieces = std::span<const Piece>;

/// From U+3000 on: Chinese and Japanese.
bool written_without_blanks(std::string_view character) {
  return byte_at(character, 0) >= 0xE3;
}

/// All that is written, in pieces. The words of `speech`, some of which overlap, only tell when a
/// piece is heard.
std::vector<Piece> pieces_of(const Speech& speech, const Script& script) {
  const Characters text(script.text);
  std::vector<Piece> pieces;
  bool blank = true;
  std::size_t next = 0;
  for (std::size_t i = 0; i < text.count(); ++i) {
    const std::string_view character = text.part(i, 1);
    if (kWhiteSpace.find(character) != std::string_view::npos) {
      blank = true;
      continue;
    }
    const bool word = next < speech.words.size() && speech.words[next].at <= i;
    if (blank || (word && written_without_blanks(character))) {
      pieces.push_back({{}, blank, false, speech.word_begin(next), speech.word_begin(next)});
    }
    blank = false;
    Piece& piece = pieces.back();
    piece.text += character;
    if (word && !piece.spoken) piece.begin = speech.word_begin(next);
    for (; next < speech.words.size() && speech.words[next].at <= i; ++next) {
      piece.spoken = true;
      piece.end = std::min(speech.word_begin(next + 1), speech.word_begin(next) + kWordMax);
    }
  }
  return pieces;
}

/// As much of a word as a caption may have.
std::string fitting(std::string word) {
  while (!protocol::is_caption(word)) word.pop_back();
  return word;
}

std::string joined(Pieces pieces) {
  std::string text;
  for (const Piece& piece : pieces) {
    if (piece.after_blank && !text.empty()) text += ' ';
    text += piece.text;
  }
  return text;
}

bool ends_sentence(std::string_view text) {
  constexpr std::array<std::string_view, 6> kMarks{".", "?", "!", "。", "？", "！"};
  return std::any_of(kMarks.begin(), kMarks.end(),
                     [text](std::string_view mark) { return text.ends_with(mark); });
}

/// In one line, or in two of the most equal lengths; nullopt if one of these is too long.
std::optional<std::string> in_lines(Pieces pieces) {
  const std::string whole = joined(pieces);
  const std::size_t length = characters(whole);
  if (pieces.size() == 1 || length <= kLineMax) return whole;
  std::size_t best = 0;
  std::size_t best_length = kLineMax + 1;
  std::size_t before = characters(pieces.front().text);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const std::size_t blank = pieces[i].after_blank ? 1 : 0;
    const std::size_t longer = std::max(before, length - before - blank);
    if (longer < best_length) {
      best = i;
      best_length = longer;
    }
    before += blank + characters(pieces[i].text);
  }
  if (best == 0) return std::nullopt;
  return joined(pieces.first(best)) + '\n' + joined(pieces.subspan(best));
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
  const std::vector<Piece> pieces = pieces_of(speech, script);
  const auto last =
      std::find_if(pieces.rbegin(), pieces.rend(), [](const Piece& piece) { return piece.spoken; });
  const auto spoken_until = static_cast<std::size_t>(pieces.rend() - last);
  std::vector<TimedCaption> captions;
  std::size_t first = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    const auto lines = in_lines(Pieces(pieces).subspan(first, i + 1 - first));
    // Marks at the end of the text have no sentence to begin.
    const bool fresh = i == 0 || (ends_sentence(pieces[i - 1].text) && i < spoken_until);
    const bool gap = i > 0 && piece.spoken && piece.begin - captions.back().end > kGapMax;
    if (fresh || gap || !lines) {
      first = i;
      captions.push_back({piece.begin, piece.end, fitting(piece.text)});
    } else {
      captions.back().text = *lines;
      if (piece.spoken) captions.back().end = piece.end;
    }
  }
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
