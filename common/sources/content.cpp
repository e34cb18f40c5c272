#include "common/sources/content.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/sources/au_columns.h"
#include "common/sources/csv_reader.h"
#include "common/sources/format.h"
#include "common/text.h"
#include "common/text_file.h"

namespace aucast::sources {
namespace {

using Numbers = std::vector<double>;

/// The numbers of a line between separators; empty when there is anything else.
Numbers numbers_of(std::string_view line, char separator) {
  Numbers numbers;
  for (std::string_view cell : split(line, separator)) {
    cell = trimmed(cell, kCsvBlanks);
    if (cell.empty() && separator == ' ') continue;
    const auto number = parse_number(cell, false);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/// The first lines that are not blank, `most` of them.
std::vector<std::string_view> first_lines(std::string_view text, std::size_t most) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < most) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = trimmed(text.substr(0, end), kCsvBlanks);
    // A longer line is no label file's.
    if (line.size() > 1000) return {};
    if (!line.empty()) lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

bool is_code(double value) {
  return value == std::floor(value) && value >= 0 && (value <= 5 || value == 9);
}

/// DISFA's and BP4D's intensities: the picture's number and one AU's code.
bool is_frame_and_code(const std::vector<std::string_view>& lines) {
  if (lines.size() < 3) return false;
  double last = -1;
  for (const std::string_view line : lines) {
    const Numbers numbers = numbers_of(line, ',');
    if (numbers.size() != 2 || !is_code(numbers[1])) return false;
    if (last >= 0 && numbers[0] != last + 1) return false;
    last = numbers[0];
  }
  return true;
}

/// BP4D's occurrences: a first line 0,1,2,4,... of all AUs.
bool is_occurrence_header(std::string_view line) {
  const Numbers numbers = numbers_of(line, ',');
  return numbers.size() >= 20 && numbers[0] == 0 &&
         std::is_sorted(numbers.begin(), numbers.end(), std::less_equal<>()) &&
         numbers.back() <= kAuNumberMax;
}

/// CK+: an AU and its intensity, such as "1.2000000e+01 3.0000000e+00".
bool is_au_and_intensity(std::string_view line) {
  return line.find("e+") != std::string_view::npos && numbers_of(line, ' ').size() == 2;
}

}  // namespace

std::optional<std::string> label_file(std::string_view text) {
  constexpr std::string_view kNeeded =
      "; needed is a table with names and times: timestamp,AU01_r,AU02_r,... with 0 to 5 in it";
  const auto lines = first_lines(text, 3);
  if (lines.empty()) return std::nullopt;
  if (is_occurrence_header(lines.front())) {
    return "this seems to be an occurrence file of BP4D: 0, 1 and 9 for each AU, without "
           "intensities and times" +
           std::string(kNeeded);
  }
  if (is_frame_and_code(lines)) {
    return "this seems to be a label file of DISFA or BP4D: pictures and the intensities of one "
           "AU, whose number stands in the file's name alone" +
           std::string(kNeeded);
  }
  if (is_au_and_intensity(lines.front())) {
    return "this seems to be a FACS file of CK+: the AUs of one picture, without times" +
           std::string(kNeeded);
  }
  return std::nullopt;
}

ContentKind content_kind(std::string_view text) {
  if (label_file(text)) return ContentKind::Unknown;
  const auto table = CsvReader::open(text, "");
  if (!table || table->columns().size() < 3) return ContentKind::StreamFile;
  if (is_known(*table)) return ContentKind::Recording;
  // A stream file without its tags has commas too, but no names, and comments with any words.
  std::size_t named = 0;
  for (const std::string& name : table->columns()) {
    if (name.find('#') != std::string::npos) return ContentKind::StreamFile;
    const auto letters = std::count_if(name.begin(), name.end(), [](char letter) {
      return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
    });
    if (letters >= 3 && name.find_first_of("{;") == std::string::npos) ++named;
  }
  return named >= 3 ? ContentKind::Unknown : ContentKind::StreamFile;
}

std::string unknown_reason(std::string_view text) {
  if (const auto labels = label_file(text)) return *labels;
  std::string reason = "a table whose columns are of no recogniser known here";
  const auto table = CsvReader::open(text, "");
  if (table && !AuColumns(*table, "AU", AuColumns::kAnySuffix).empty()) {
    reason += ", though there are AUs: named AU01_r, AU02_r, ... beside a timestamp they are read";
  }
  return reason +
         "; known are OpenFace (AU01_r, ... with timestamp or confidence), FACSvatar, Py-Feat "
         "(AU01, ... with FaceScore), LibreFace (au_1_intensity, ...), FaceReader (Action Unit 01 "
         "- ..., ...), iMotions (AU1 Evidence, ... or Brow Furrow, ...), Live Link Face and curves "
         "of ARKit or MediaPipe (jawOpen, ...)";
}

}  // namespace aucast::sources
