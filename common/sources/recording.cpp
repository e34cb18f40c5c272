#include "common/sources/recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <unordered_map>
#include <utility>

#include "common/sources/content.h"
#include "common/sources/format.h"
#include "common/sources/row_reading.h"
#include "common/sources/timeline.h"
#include "common/stopped.h"
#include "common/text.h"

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

/// How many usual steps a second has; pauses and hitches do not count.
double steps_a_second(const protocol::StreamFile& stream) {
  if (stream.keyframes.empty()) return 0;
  // The first keyframe takes the usual time.
  const double usual = stream.keyframes.front().time_ms.value_or(0);
  double sum = 0;
  double steps = 0;
  for (const protocol::Keyframe& keyframe : stream.keyframes) {
    const double step = keyframe.time_ms.value_or(0);
    if (step < usual / 2 || step > usual * 1.5) continue;
    sum += step;
    ++steps;
  }
  return sum > 0 ? 1000 * steps / sum : 0;
}

/// How many first seconds are proposed when a face is not neutral in those that were asked for.
constexpr std::array<double, 7> kNeutralSeconds{1, 2, 5, 10, 20, 30, 60};

/// One face on its way through a pass that measures it.
struct FirstSeconds {
  std::vector<NeutralMeter> meters;  ///< ascending
  SourceClock clock;
  FaceTimes times;
};
using FirstSecondsOfFaces = std::unordered_map<std::int64_t, FirstSeconds>;

/// One face on its way through the last pass.
struct Track {
  Found found;
  Timeline timeline;
  FaceTimes times;
  bool has_begun = false;
  double last_seconds = 0;
  double last_sure = 0;
  bool broken = false;  ///< its time has jumped, which was refused
};

class RecordingReader {
 public:
  RecordingReader(CsvReader& table, Format& format, std::string_view file,
                  const RecordingOptions& options, const ConditioningSettings& conditioning)
      : table_(table),
        format_(format),
        file_(file),
        options_(options),
        conditioning_(conditioning) {}

  Result<std::vector<Recording>> read();

 private:
  void survey();
  [[nodiscard]] std::optional<Error> settle();
  [[nodiscard]] std::optional<Error> choose();
  [[nodiscard]] bool sure(const Observation& row) const {
    return is_sure(row, options_.confidence_min);
  }
  void prepare(std::int64_t face);
  [[nodiscard]] FirstSecondsOfFaces measured_in(const std::vector<std::int64_t>& faces,
                                                std::span<const double> spans);
  void measure();
  void propose_neutral(const std::vector<std::int64_t>& faces);
  void play();
  void take(const Observation& row, Track& track);
  [[nodiscard]] Result<std::vector<Recording>> finish();
  [[nodiscard]] std::string needs_fps() const;
  [[nodiscard]] Error need(const std::string& reason) const;

  CsvReader& table_;
  Format& format_;
  std::string_view file_;
  const RecordingOptions& options_;
  Found found_;                       ///< what the faces have in common
  std::vector<std::int64_t> chosen_;  ///< faces to be read, the most frequent first
  std::unordered_map<std::int64_t, Track> tracks_;
  ConditioningSettings conditioning_;
  bool timed_ = false;  ///< some row has a time
  SourceClock clock_{options_.fps};
};

Result<std::vector<Recording>> RecordingReader::read() {
  survey();
  if (table_.stopped()) return stopped_early();
  if (auto error = settle()) return *error;
  for (const std::int64_t face : chosen_) prepare(face);
  measure();
  table_.rewind();
  play();
  if (table_.stopped()) return stopped_early();
  if (table_.has_errors()) return table_.error();
  return finish();
}

/// First pass: everything that only the whole file can tell.
void RecordingReader::survey() {
  Found& found = found_;
  found.format = format_.name();
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
      if (fits_no_scale(au)) {
        ++found.off_scale;
      } else if (au.native) {
        found.largest = std::max(found.largest.value_or(0), au.value);
      }
    }
  }
}

/// Decides what was open; an error when the file cannot be played.
std::optional<Error> RecordingReader::settle() {
  Found& found = found_;
  if (table_.has_errors()) return table_.error();
  found.note = format_.note();
  if (found.faces.empty()) {
    return Error{ErrorKind::BadData,
                 at_place(file_, table_.line(), 1, "the recording has no rows")};
  }
  if (!timed_ && !options_.fps) {
    return need(found.format + " wrote no times here; " + needs_fps());
  }
  found.scale_asked = options_.au_scale.has_value();
  found.scale =
      options_.au_scale.value_or(scale_for(format_.native_scale(), found.largest.value_or(0)));
  return choose();
}

/// Which faces are read.
std::optional<Error> RecordingReader::choose() {
  std::vector<Found::Face> faces = found_.faces;
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Found::Face& a, const Found::Face& b) { return a.rows > b.rows; });
  if (options_.all_faces) {
    faces.resize(std::min(faces.size(), kFacesReadMax));
    for (const Found::Face& face : faces) chosen_.push_back(face.id);
    return std::nullopt;
  }
  const std::int64_t face = options_.face.value_or(faces.front().id);
  chosen_.push_back(face);
  if (std::any_of(faces.begin(), faces.end(),
                  [face](const Found::Face& other) { return other.id == face; })) {
    return std::nullopt;
  }
  return need("there is no face " + std::to_string(face) + "; the most frequent one is " +
              std::to_string(faces.front().id));
}

std::string RecordingReader::needs_fps() const {
  return "say how many pictures a second there are, such as " + std::string(options_.names.fps) +
         " 30";
}

Error RecordingReader::need(const std::string& reason) const {
  return {ErrorKind::Usage, at_place(file_, reason)};
}

void RecordingReader::prepare(std::int64_t face) {
  Track& track = tracks_[face];
  track.found = found_;
  track.found.face = face;
  track.found.all_taken = options_.all_faces;
  track.timeline = Timeline(conditioning_);
}

/// The first seconds of these faces, in one pass, which ends when all have been measured.
FirstSecondsOfFaces RecordingReader::measured_in(const std::vector<std::int64_t>& faces,
                                                 std::span<const double> spans) {
  FirstSecondsOfFaces measured;
  for (const std::int64_t face : faces) {
    measured.emplace(face,
                     FirstSeconds{{spans.begin(), spans.end()}, SourceClock(options_.fps), {}});
  }
  std::size_t unfinished = faces.size();
  FaceNames names;
  Observation row;
  table_.rewind();
  for (auto next = table_.next(); next != CsvReader::Next::End && unfinished > 0;
       next = table_.next()) {
    if (next == CsvReader::Next::RepeatedHeader) {
      for (auto& [face, first] : measured) first.clock.restart();
    }
    if (next != CsvReader::Next::Row) continue;
    row.clear();
    format_.read(table_, row);
    const auto found = measured.find(names.of(row));
    if (found == measured.end() || found->second.meters.back().done()) continue;
    FirstSeconds& first = found->second;
    const auto time = first.clock.seconds_of(row, first.times);
    if (!time) continue;
    const Signals signals = raw_signals(update_of(row, found_.scale, sure(row)), conditioning_);
    for (NeutralMeter& meter : first.meters) meter.add(*time, signals);
    if (first.meters.back().done()) --unfinished;
  }
  return measured;
}

/// Measures what is to be subtracted, if asked to: in the first seconds of each chosen face.
void RecordingReader::measure() {
  const auto seconds = seconds_to_measure(conditioning_);
  if (!seconds) return;
  const FirstSecondsOfFaces first = measured_in(chosen_, {&*seconds, 1});
  std::vector<std::int64_t> loud;  // not neutral then
  for (const std::int64_t face : chosen_) {
    Track& track = tracks_[face];
    const MeasuredNeutral measured = first.at(face).meters.front().measured();
    if (conditioning_.neutral_seconds) {
      track.found.neutral = taken_off(conditioning_, measured);
      if (!conditioning_.neutral_turns_only)
        track.found.not_neutral = loud_aus(*track.found.neutral);
      if (!track.found.not_neutral.empty()) loud.push_back(face);
    }
    ConditioningSettings settled = conditioning_;
    settled.profile.neutral = neutral_with(conditioning_, measured);
    settled.neutral_seconds.reset();
    track.timeline = Timeline(settled);
  }
  propose_neutral(loud);
}

/// Looks for a number of first seconds in which each of these faces is neutral.
void RecordingReader::propose_neutral(const std::vector<std::int64_t>& faces) {
  for (const auto& [face, first] : measured_in(faces, kNeutralSeconds)) {
    for (std::size_t i = 0; i < kNeutralSeconds.size() && first.meters[i].done(); ++i) {
      if (!loud_aus(first.meters[i].measured()).empty()) continue;
      tracks_[face].found.neutral_seconds = kNeutralSeconds[i];
      break;
    }
  }
}

/// Last pass: the keyframes of the chosen faces.
void RecordingReader::play() {
  FaceNames names;
  Observation row;
  for (auto next = table_.next(); next != CsvReader::Next::End; next = table_.next()) {
    if (next == CsvReader::Next::RepeatedHeader) clock_.restart();
    if (next != CsvReader::Next::Row) continue;
    row.clear();
    format_.read(table_, row);
    const auto track = tracks_.find(names.of(row));
    if (track != tracks_.end()) take(row, track->second);
  }
}

void RecordingReader::take(const Observation& row, Track& track) {
  Found& found = track.found;
  ++found.rows;
  const auto time = clock_.seconds_of(row, track.times);
  if (!time) {
    ++found.left_out;
    return;
  }
  if (track.broken) return;
  if (*time - track.last_seconds > kGapSecondsMax) {
    table_.refuse(std::nullopt, "the time jumps by more than a day");
    track.broken = true;
    return;
  }
  // Who comes late was neutral until then.
  if (!std::exchange(track.has_begun, true) && *time > 0) {
    static_cast<void>(track.timeline.add(0, update_of({}, found.scale, false)));
  }
  if (!track.timeline.add(*time, update_of(row, found.scale, sure(row)))) ++found.left_out;
  track.last_seconds = *time;
  if (sure(row)) {
    count_gap(*time - track.last_sure, found);
    track.last_sure = *time;
  } else {
    ++found.lost;
  }
}

Result<std::vector<Recording>> RecordingReader::finish() {
  std::vector<Recording> recordings;
  bool one_time = false;
  bool no_time = true;  // that could be read
  for (const std::int64_t face : chosen_) {
    Track& track = tracks_[face];
    count_gap(track.last_seconds - track.last_sure, track.found);
    if (track.last_seconds > 0) {
      const auto steps = static_cast<double>(track.found.rows - 1);
      track.found.rows_a_second = steps / track.last_seconds;
    }
    no_time = no_time && track.found.left_out == track.found.rows;
    Recording recording{track.timeline.finish(), std::move(track.found)};
    recording.found.steps_a_second = steps_a_second(recording.stream);
    const std::size_t keyframes = recording.stream.keyframes.size();
    // A tracker's passing mistakes are no people, as long as there are people.
    const bool nobody = options_.all_faces && recording.found.lost == recording.found.rows;
    if (keyframes == 0 || nobody) continue;
    if (keyframes == 1 && recording.found.rows > 1) {
      one_time = true;  // all its rows
    } else {
      recordings.push_back(std::move(recording));
    }
  }
  if (!recordings.empty()) return recordings;
  if (one_time) return need("no row has a later time than the first; " + needs_fps());
  if (timed_ && no_time) {
    return Error{ErrorKind::BadData,
                 at_place(file_, "no row has a time of at most " +
                                     std::to_string(static_cast<std::int64_t>(kClockSecondsMax)) +
                                     " s: it may be told in microseconds; " + needs_fps())};
  }
  if (timed_ || options_.fps) return need("no face is seen in any row");
  return need("no row has a time; " + needs_fps());
}

}  // namespace

Result<std::vector<Recording>> read_faces(std::string_view text, std::string_view file,
                                          const RecordingOptions& options,
                                          const ConditioningSettings& conditioning,
                                          const LoadCurves& load_curves,
                                          const std::stop_token& stop) {
  auto table = CsvReader::open(text, file, stop);
  if (!table) return table.error();
  const auto format = open_format(*table, load_curves);
  if (!format) return format.error();
  if (!*format) {
    table->refuse(std::nullopt, unknown_reason(text));
    return table->error();
  }
  return RecordingReader(*table, **format, file, options, conditioning).read();
}

}  // namespace aucast::sources
