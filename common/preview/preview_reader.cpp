#include "common/preview/preview_reader.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/number_of.h"
#include "common/text.h"

namespace aucast::preview {
namespace {

constexpr std::size_t kPointBytes = 4;

float share_at(std::string_view bytes) {
  const auto low = static_cast<unsigned char>(bytes[0]);
  const auto high = static_cast<unsigned char>(bytes[1]);
  return static_cast<float>(low + 256U * high) / 65535;
}

std::optional<AuTerm> term_of(std::string_view word) {
  AuTerm term;
  if (word.starts_with('L')) term.side = Side::Left;
  if (word.starts_with('R')) term.side = Side::Right;
  if (term.side != Side::Both) word.remove_prefix(1);
  const std::size_t colon = word.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto number = number_of<std::uint8_t>(word.substr(0, colon));
  const auto percent = number_of<std::uint8_t>(word.substr(colon + 1));
  if (!number || *number == 0 || *number > kAuNumberMax) return std::nullopt;
  if (!percent || *percent > 100) return std::nullopt;
  term.number = *number;
  term.percent = *percent;
  return term;
}

std::optional<std::vector<AuTerm>> terms_of(std::string_view text) {
  std::vector<AuTerm> terms;
  if (text.empty()) return terms;
  for (const std::string_view word : split(text, ',')) {
    const auto term = term_of(word);
    if (!term) return std::nullopt;
    terms.push_back(*term);
  }
  return terms;
}

/// The rest of a line that begins with `word` and a blank.
std::optional<std::string_view> after(std::string_view line, std::string_view word) {
  if (!line.starts_with(word) || line.size() <= word.size() + 1 || line[word.size()] != ' ') {
    return std::nullopt;
  }
  return line.substr(word.size() + 1);
}

}  // namespace

Error PreviewReader::broken(std::string_view line) {
  broken_ = true;
  return {ErrorKind::BadData, "what au-transmitter says is no preview: '" + escaped(line) + "'"};
}

Result<std::optional<Record>> PreviewReader::next() {
  const std::size_t end = bytes_.find('\n');
  if (broken_ || end > kTextMax) {
    if (end == std::string::npos && bytes_.size() <= kTextMax && !broken_) {
      return std::optional<Record>();
    }
    return broken(std::string_view(bytes_).substr(0, kTextMax));
  }
  const std::string line = bytes_.substr(0, end);
  return after(line, "seen") ? take_seen(line, end + 1) : take_line(line, end + 1);
}

Result<std::optional<Record>> PreviewReader::take_line(std::string_view line,
                                                       std::size_t line_bytes) {
  std::optional<Record> record;
  if (const auto where = after(line, "listening on")) {
    const std::size_t blank = std::min(where->find(' '), where->size());
    record = Listening{std::string(where->substr(0, blank)),
                       std::string(where->substr(std::min(blank + 1, where->size())))};
  } else if (const auto open = after(line, "live")) {
    record = Live{std::string(*open)};
  } else if (line == "private") {
    record = Private{};
  } else if (const auto sentence = after(line, "refused")) {
    record = Refused{std::string(*sentence)};
  } else if (const auto word = after(line, "watching")) {
    if (const auto count = number_of<std::uint32_t>(*word)) record = Watching{*count};
  }
  if (!record) return broken(line);
  bytes_.erase(0, line_bytes);
  return record;
}

Result<std::optional<Record>> PreviewReader::take_seen(std::string_view line,
                                                       std::size_t line_bytes) {
  const auto words = split_words(line);
  std::vector<std::size_t> numbers;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto number = number_of<std::uint32_t>(words[i]);
    if (!number) return broken(line);
    numbers.push_back(*number);
  }
  const auto is_side = [](std::size_t side) { return side >= 1 && side <= kSideMax; };
  if (numbers.size() != 4 || !is_side(numbers[0]) || !is_side(numbers[1]) ||
      numbers[2] > kPointsMax || numbers[3] > kTextMax) {
    return broken(line);
  }
  const std::size_t rgb_bytes = 3 * numbers[0] * numbers[1];
  const std::size_t points_bytes = kPointBytes * numbers[2];
  const std::size_t all = line_bytes + rgb_bytes + points_bytes + numbers[3];
  if (bytes_.size() < all) return std::optional<Record>();
  const std::string_view body = std::string_view(bytes_).substr(line_bytes, all - line_bytes);
  const std::string_view text = body.substr(rgb_bytes + points_bytes);
  auto aus = terms_of(text);
  if (!aus) return broken(text);
  Seen seen{numbers[0], numbers[1], {}, {}, *std::move(aus)};
  seen.rgb.assign(body.begin(), body.begin() + static_cast<std::ptrdiff_t>(rgb_bytes));
  for (std::size_t i = 0; i < numbers[2]; ++i) {
    const std::string_view point = body.substr(rgb_bytes + kPointBytes * i, kPointBytes);
    seen.points.push_back({share_at(point), share_at(point.substr(2))});
  }
  bytes_.erase(0, all);
  return std::optional<Record>(std::move(seen));
}

}  // namespace aucast::preview
