#include "server/sources/recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "common/text.h"
#include "server/sources/format.h"
#include "server/sources/live_link_face.h"
#include "server/sources/row_reading.h"
#include "server/sources/timeline.h"

namespace aucast::sources {
namespace {

/// Times further apart are a mistake, not a pause.
constexpr double kGapSecondsMax = 86'400;

/// Counts the stretches without a sure row that are longer than the hold.
void count_gap(double seconds, Found& found) {
  if (seconds <= kHoldSeconds) return;
  ++found.gaps;
  found.gap_seconds_max = std::max(found.gap_seconds_max, seconds);
}

class RecordingReader {
 public:
  RecordingReader(CsvReader& table, Format& format, std::string_view file,
                  const RecordingOptions& options)
      : table_(table), format_(format), file_(file), options_(options) {}

  Result<Recording> read();

 private:
  void survey();
  [[nodiscard]] std::optional<Error> settle();
  [[nodiscard]] bool sure(const Observation& row) const {
    return is_sure(row, options_.confidence_min);
  }
  void play();
  void take(const Observation& row, Timeline& timeline);
  [[nodiscard]] Error need(const std::string& reason) const;

  CsvReader& table_;
  Format& format_;
  std::string_view file_;
  const RecordingOptions& options_;
  Recording recording_;
  bool timed_ = false;  ///< some row has a time
  SourceClock clock_{options_.fps};
  double last_seconds_ = 0;
  double last_sure_ = 0;
};

Result<Recording> RecordingReader::read() {
  survey();
  if (auto error = settle()) return *error;
  table_.rewind();
  play();
  if (table_.has_errors()) return table_.error();
  if (recording_.stream.keyframes.empty()) {
    return need("no row has a time; say how many pictures a second there are, such as --fps 30");
  }
  if (recording_.stream.keyframes.size() == 1 && recording_.found.rows > 1) {
    return need(
        "all rows have the same time; say how many pictures a second there are, such as "
        "--fps 30");
  }
  return std::move(recording_);
}

/// First pass: everything that only the whole file can tell.
void RecordingReader::survey() {
  Found& found = recording_.found;
  found.format = format_.name();
  found.approximate = format_.approximate();
  FaceNames names;
  std::unordered_map<std::int64_t, std::size_t> places;
  Observation row;
  for (auto next = table_.next(); next != CsvReader::Next::End; next = table_.next()) {
    if (next == CsvReader::Next::RepeatedHeader) ++found.headers;
    if (next == CsvReader::Next::Truncated) found.truncated = true;
    if (next != CsvReader::Next::Row) continue;
    row.clear();
    format_.scan(table_);
    format_.read(table_, row);
    timed_ |= row.seconds.has_value();
    const std::int64_t id = names.of(row);
    const auto [at, fresh] = places.emplace(id, found.faces.size());
    if (fresh) found.faces.push_back({id, 0});
    ++found.faces[at->second].rows;
    if (!sure(row)) continue;
    for (const AuValue& au : row.aus) {
      if (au.native) found.largest = std::max(found.largest, au.value);
    }
  }
}

/// Decides what was open; an error when the file cannot be played.
std::optional<Error> RecordingReader::settle() {
  Found& found = recording_.found;
  if (table_.has_errors()) return table_.error();
  if (found.faces.empty()) {
    return Error{ErrorKind::BadData,
                 at_place(file_, table_.line(), 1, "the recording has no rows")};
  }
  if (!timed_ && !options_.fps) {
    return need(found.format +
                " wrote no times here; say how many pictures a second there are, such as --fps 30");
  }
  found.scale_asked = options_.au_scale.has_value();
  found.scale = options_.au_scale.value_or(scale_for(format_.native_scale(), found.largest));
  const auto most =
      std::max_element(found.faces.begin(), found.faces.end(),
                       [](const Found::Face& a, const Found::Face& b) { return a.rows < b.rows; });
  found.face = options_.face.value_or(most->id);
  const auto chosen =
      std::find_if(found.faces.begin(), found.faces.end(),
                   [&found](const Found::Face& face) { return face.id == found.face; });
  if (chosen != found.faces.end()) return std::nullopt;
  return need("there is no face " + std::to_string(found.face) + "; the most frequent one is " +
              std::to_string(most->id));
}

Error RecordingReader::need(const std::string& reason) const {
  return {ErrorKind::Usage, at_place(file_, 0, 0, reason)};
}

/// Second pass: the keyframes of the chosen face.
void RecordingReader::play() {
  FaceNames names;
  Observation row;
  Timeline timeline;
  for (auto next = table_.next(); next != CsvReader::Next::End; next = table_.next()) {
    if (next == CsvReader::Next::RepeatedHeader) clock_.restart();
    if (next != CsvReader::Next::Row) continue;
    row.clear();
    format_.read(table_, row);
    if (names.of(row) == recording_.found.face) take(row, timeline);
  }
  count_gap(last_seconds_ - last_sure_, recording_.found);
  recording_.stream = timeline.finish();
}

void RecordingReader::take(const Observation& row, Timeline& timeline) {
  Found& found = recording_.found;
  ++found.rows;
  const auto moment = clock_.moment(row);
  if (!moment) {
    ++found.left_out;
    return;
  }
  if (*moment - last_seconds_ > kGapSecondsMax) {
    table_.refuse(std::nullopt, "the time jumps by more than a day");
    last_seconds_ = *moment;
    return;
  }
  if (!timeline.add(*moment, update_of(row, found.scale, sure(row)))) ++found.left_out;
  last_seconds_ = *moment;
  if (sure(row)) {
    count_gap(*moment - last_sure_, found);
    last_sure_ = *moment;
  } else {
    ++found.lost;
  }
}

}  // namespace

ContentKind content_kind(std::string_view text) {
  // A comment may have any words, and a stream file any number of them.
  if (text.substr(0, text.find('\n')).find('#') != std::string_view::npos) {
    return ContentKind::StreamFile;
  }
  const auto table = CsvReader::open(text, "");
  if (!table || table->columns().size() < 3) return ContentKind::StreamFile;
  if (is_live_link_face(*table)) return ContentKind::LiveLinkFace;
  if (open_format(*table, {})) return ContentKind::Recording;
  // A stream file without its tags has commas too, but no names.
  const auto named =
      std::count_if(table->columns().begin(), table->columns().end(), [](const std::string& name) {
        return name.size() >= 3 && name.find_first_of("#{;") == std::string::npos &&
               std::count_if(name.begin(), name.end(), [](char letter) {
                 return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
               }) >= 3;
      });
  return named >= 3 ? ContentKind::UnknownTable : ContentKind::StreamFile;
}

Result<Recording> read_recording(std::string_view text, std::string_view file,
                                 const RecordingOptions& options, const ArkitTable& curves) {
  auto table = CsvReader::open(text, file);
  if (!table) return table.error();
  const auto format = open_format(*table, curves);
  if (!format) {
    table->refuse(std::nullopt, std::string(kUnknownTable));
    return table->error();
  }
  return RecordingReader(*table, *format, file, options).read();
}

}  // namespace aucast::sources
