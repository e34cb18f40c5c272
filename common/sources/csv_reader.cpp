#include "common/sources/csv_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "common/text.h"
#include "common/text_file.h"

namespace aucast::sources {
namespace {

std::string_view unquoted(std::string_view cell) {
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  return trimmed(cell.substr(1, cell.size() - 2), kCsvBlanks);
}

char separator_of(std::string_view header) {
  char best = ',';
  for (const char candidate : {';', '\t'}) {
    if (std::count(header.begin(), header.end(), candidate) >
        std::count(header.begin(), header.end(), best)) {
      best = candidate;
    }
  }
  return best;
}

/// The words for "no data" of C, C++, Python, R, Excel and FaceReader, in small letters without a
/// sign.
bool means_no_data(std::string_view cell) {
  constexpr std::array<std::string_view, 12> kWords = {
      "nan",  "inf",  "infinity", "na",         "n/a",         "nan(ind)",
      "null", "none", "#n/a",     "fit_failed", "find_failed", "unknown"};
  if (cell.empty()) return true;
  if (cell.front() == '-' || cell.front() == '+') cell.remove_prefix(1);
  const std::string word = lowered(cell.substr(0, 16));
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

/// Groups of three digits after each comma: "12,345".
bool are_thousands(std::string_view whole) {
  while (true) {
    const std::size_t comma = whole.rfind(',');
    if (comma == std::string_view::npos) return !whole.empty();
    if (whole.size() - comma != 4) return false;
    whole.remove_suffix(4);
  }
}

}  // namespace

bool is_preamble(std::string_view line) {
  line = unquoted(trimmed(line, kCsvBlanks));
  const std::string_view first = trimmed(line.substr(0, line.find('\t')), kCsvBlanks);
  return line.starts_with('#') || line.starts_with("sep=") || line.ends_with("detailed log") ||
         first.ends_with(':');
}

std::optional<double> parse_number(std::string_view text, bool commas) {
  if (text.starts_with('+')) text.remove_prefix(1);
  std::string plain;
  if (commas && text.find(',') != std::string_view::npos) {
    const std::size_t dot = text.find('.');
    const bool single = text.find(',') == text.rfind(',');
    plain = text;
    if (dot == std::string_view::npos && single) {
      std::replace(plain.begin(), plain.end(), ',', '.');
    } else {
      const bool commas_after_dot = dot != std::string_view::npos && text.rfind(',') > dot;
      if (commas_after_dot || !are_thousands(text.substr(0, dot))) return std::nullopt;
      plain.erase(std::remove(plain.begin(), plain.end(), ','), plain.end());
    }
    text = plain;
  }
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stopped != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

Result<CsvReader> CsvReader::open(std::string_view text, std::string_view file,
                                  std::stop_token stop) {
  CsvReader reader(text, file, std::move(stop));
  if (text.starts_with(kByteOrderMark)) reader.position_ = kByteOrderMark.size();
  // A line that ends in CR alone: all of them do.
  const std::size_t end = text.find_first_of("\r\n");
  if (end != std::string_view::npos && text[end] == '\r' && text.substr(end + 1, 1) != "\n") {
    reader.line_end_ = '\r';
  }
  if (auto read = reader.read_header(); !read) return read.error();
  return reader;
}

Result<void> CsvReader::read_header() {
  do {
    if (!take_line()) {
      refuse_at(0, "the file holds nothing; expected a line with the names of columns");
      return error();
    }
  } while (trimmed(content_, kCsvBlanks).empty() || is_preamble(content_));
  header_ = trimmed(content_, kCsvBlanks);
  separator_ = separator_of(header_);
  if (content_.size() > kCsvLineBytesMax) {
    refuse_at(kCsvLineBytesMax,
              "the line is longer than " + std::to_string(kCsvLineBytesMax) + " bytes");
    return error();
  }
  split();
  if (cells_.size() > kCsvColumnsMax) {
    refuse_at(0, "more than " + std::to_string(kCsvColumnsMax) + " columns");
    return error();
  }
  for (const std::string_view cell : cells_) columns_.emplace_back(unquoted(cell));
  rows_begin_ = position_;
  rows_line_ = line_;
  return {};
}

std::optional<std::size_t> CsvReader::column(std::string_view name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

bool CsvReader::take_line() {
  if (position_ >= text_.size()) return false;
  const std::size_t end = text_.find(line_end_, position_);
  ended_ = end != std::string_view::npos;
  content_ = text_.substr(position_, ended_ ? end - position_ : std::string_view::npos);
  position_ = ended_ ? end + 1 : text_.size();
  ++line_;
  return true;
}

CsvReader::Next CsvReader::next() {
  do {
    if (stopped() || !take_line()) return Next::End;
  } while (trimmed(content_, kCsvBlanks).empty());
  return read_row();
}

CsvReader::Next CsvReader::take(std::string_view content, std::size_t line) {
  content_ = content;
  ended_ = true;
  line_ = line;
  return read_row();
}

CsvReader::Next CsvReader::read_row() {
  if (trimmed(content_, kCsvBlanks) == header_) return Next::RepeatedHeader;
  if (content_.size() > kCsvLineBytesMax) {
    refuse_at(kCsvLineBytesMax,
              "the line is longer than " + std::to_string(kCsvLineBytesMax) + " bytes");
    return Next::Faulty;
  }
  split();
  if (cells_.size() == columns_.size()) return Next::Row;
  if (!ended_ && cells_.size() < columns_.size()) return Next::Truncated;
  std::string reason = "the row has " + std::to_string(cells_.size()) +
                       " cells, the header names " + std::to_string(columns_.size());
  if (separator_ == ',' && cells_.size() > columns_.size()) {
    reason += "; numbers with commas must be quoted, or the cells separated by ';'";
  }
  refuse_at(0, reason);
  return Next::Faulty;
}

void CsvReader::rewind() {
  position_ = rows_begin_;
  line_ = rows_line_;
}

void CsvReader::split() {
  cells_.clear();
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= content_.size() && cells_.size() <= kCsvColumnsMax; ++at) {
    if (at < content_.size() && content_[at] == '"') quoted = !quoted;
    if (at < content_.size() && (quoted || content_[at] != separator_)) continue;
    cells_.push_back(trimmed(content_.substr(begin, at - begin), kCsvBlanks));
    begin = at + 1;
  }
}

std::string_view CsvReader::text(std::optional<std::size_t> column) const {
  if (!column || *column >= cells_.size()) return {};
  return unquoted(cells_[*column]);
}

std::optional<double> CsvReader::number(std::optional<std::size_t> column) {
  const std::string_view cell = text(column);
  if (cell.empty()) return std::nullopt;
  const auto value = parse_number(cell, true);
  if (!value && !means_no_data(cell))
    refuse(column, "'" + escaped(cell) + "' in " + escaped(columns_[*column]) + " is not a number");
  return value;
}

void CsvReader::refuse(std::optional<std::size_t> column, const std::string& reason) {
  const bool there = column && *column < cells_.size();
  refuse_at(there ? static_cast<std::size_t>(cells_[*column].data() - content_.data()) : 0, reason);
}

void CsvReader::refuse_at(std::size_t byte, const std::string& reason) {
  errors_.add(std::max<std::size_t>(line_, 1), byte + 1, reason);
}

}  // namespace aucast::sources
