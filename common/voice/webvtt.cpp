#include "common/voice/webvtt.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "common/number_of.h"
#include "common/text.h"
#include "common/text_file.h"
#include "protocol/caption.h"
#include "protocol/limits.h"

namespace aucast::voice {
namespace {

constexpr std::string_view kArrow = "-->";
constexpr std::string_view kBlanks = " \t";
constexpr auto kPlaceMsMax = static_cast<std::uint64_t>(protocol::kPlaceMsMax);

struct Line {
  std::string_view text;
  std::size_t number = 0;
};

struct Cue {
  std::uint64_t begin_ms = 0;
  std::uint64_t end_ms = 0;
  std::string text;
  Line times;
};

/// The lines without their ends, be they LF, CR LF or CR.
std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back({text.substr(0, end), lines.size() + 1});
    const std::size_t length = text.substr(end).starts_with("\r\n") ? 2 : 1;
    text.remove_prefix(std::min(end + length, text.size()));
  }
  return lines;
}

/// "[HH...:]MM:SS.mmm"
std::optional<std::uint64_t> time_of(std::string_view text) {
  const std::size_t point = text.rfind('.');
  if (point == std::string_view::npos || text.size() - point != 4) return std::nullopt;
  const auto ms = number_of<unsigned>(text.substr(point + 1));
  const std::vector<std::string_view> parts = split(text.substr(0, point), ':');
  if (!ms || parts.size() < 2 || parts.size() > 3) return std::nullopt;
  std::uint64_t time_s = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto part = number_of<unsigned>(parts[i]);
    const bool hours = i + 3 == parts.size();
    const bool fits = hours ? parts[i].size() <= 6 : parts[i].size() == 2 && part < 60U;
    if (!part || !fits) return std::nullopt;
    time_s = time_s * 60 + *part;
  }
  return time_s * 1000 + *ms;
}

/// The text without <tags> and with the characters that escapes stand for.
std::string without_markup(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kEscapes{{
      {"&amp;", "&"},
      {"&lt;", "<"},
      {"&gt;", ">"},
      {"&nbsp;", "\u00A0"},
      {"&lrm;", "\u200E"},
      {"&rlm;", "\u200F"},
  }};
  std::string plain;
  while (!text.empty()) {
    const auto escape =
        std::find_if(kEscapes.begin(), kEscapes.end(),
                     [text](const auto& candidate) { return text.starts_with(candidate.first); });
    if (escape != kEscapes.end()) {
      plain += escape->second;
      text.remove_prefix(escape->first.size());
    } else if (text.front() == '<') {
      text.remove_prefix(std::min(text.find('>'), text.size() - 1) + 1);
    } else {
      plain += text.front() == '\t' ? ' ' : text.front();
      text.remove_prefix(1);
    }
  }
  return plain;
}

Error bad(std::string_view file, const Line& line, std::size_t column, std::string_view why) {
  return {ErrorKind::BadData, at_place(file, line.number, column, why)};
}

/// The times of a cue. Settings after them are left out.
Result<Cue> read_times(const Line& line, std::string_view file) {
  const std::size_t arrow = line.text.find(kArrow);
  const std::string_view after = line.text.substr(arrow + kArrow.size());
  const std::string_view rest = trimmed(after, kBlanks);
  const auto begin = time_of(trimmed(line.text.substr(0, arrow), kBlanks));
  const auto end = time_of(rest.substr(0, rest.find_first_of(kBlanks)));
  if (!begin) return bad(file, line, 1, "no time such as 00:01:02.345 before -->");
  if (!end) {
    return bad(file, line, arrow + kArrow.size() + 1, "no time such as 00:01:02.345 after -->");
  }
  if (std::max(*begin, *end) > kPlaceMsMax) {
    return bad(file, line, 1,
               "a caption later than " + std::to_string(kPlaceMsMax / 3'600'000) +
                   " hours, which is as far as a stream goes");
  }
  if (*end < *begin) return bad(file, line, arrow + 1, "the caption ends before it begins");
  return Cue{*begin, *end, {}, line};
}

/// The cues of a file whose first line was read.
Result<std::vector<Cue>> read_cues(std::vector<Line>::const_iterator line,
                                   std::vector<Line>::const_iterator end, std::string_view file) {
  std::vector<Cue> cues;
  bool in_cue = false;
  for (; line != end; ++line) {
    if (line->text.empty()) {
      in_cue = false;
    } else if (line->text.find(kArrow) != std::string_view::npos) {
      auto cue = read_times(*line, file);
      if (!cue) return cue.error();
      cues.push_back(std::move(*cue));
      in_cue = true;
    } else if (in_cue) {
      std::string& text = cues.back().text;
      text += (text.empty() ? "" : "\n") + without_markup(line->text);
      if (!protocol::is_caption(text)) {
        return bad(file, cues.back().times, 1,
                   "the caption that begins here is too long, or no UTF-8 text");
      }
    }
  }
  // A caption of no time is seen by nobody.
  std::erase_if(cues, [](const Cue& cue) { return cue.end_ms == cue.begin_ms; });
  std::stable_sort(cues.begin(), cues.end(),
                   [](const Cue& a, const Cue& b) { return a.begin_ms < b.begin_ms; });
  return cues;
}

}  // namespace

Result<std::vector<protocol::CaptionData>> parse_webvtt(std::string_view text,
                                                        std::string_view file) {
  constexpr std::string_view kSignature = "WEBVTT";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::vector<Line> lines = lines_of(text);
  const bool signed_first = !lines.empty() && lines.front().text.starts_with(kSignature);
  const std::string_view after =
      signed_first ? lines.front().text.substr(kSignature.size()) : std::string_view();
  if (!signed_first || (!after.empty() && kBlanks.find(after.front()) == std::string_view::npos)) {
    return Error{ErrorKind::BadData,
                 at_place(file, 1, 1, "no captions: it must begin with WEBVTT")};
  }
  const auto cues = read_cues(lines.begin() + 1, lines.end(), file);
  if (!cues) return cues.error();
  std::vector<protocol::CaptionData> captions;
  for (std::size_t i = 0; i < cues->size(); ++i) {
    const Cue& cue = (*cues)[i];
    if (!captions.empty() && captions.back().place_ms == cue.begin_ms) captions.pop_back();
    captions.push_back({cue.begin_ms, cue.text});
    const bool gap = i + 1 == cues->size() || (*cues)[i + 1].begin_ms > cue.end_ms;
    if (gap) captions.push_back({cue.end_ms, {}});
  }
  return captions;
}

}  // namespace aucast::voice
