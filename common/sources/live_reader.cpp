#include "common/sources/live_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/sources/content.h"
#include "common/sources/format.h"
#include "common/text.h"
#include "common/text_file.h"
#include "protocol/limits.h"
#include "protocol/stream_file.h"

namespace aucast::sources {
namespace {

constexpr std::string_view kBlanks = " \t";

/// Rows closer together than this came at once: no recogniser is that fast.
constexpr Seconds kAtOnce(0.005);
/// The time of a row that came at once with the one before and has no clock.
constexpr Seconds kRow(0.04);

/// How many lines tell labels of a database from lines of a stream file.
constexpr std::size_t kBeginningLines = 3;
/// What of each of them is kept: a longer line is no label file's.
constexpr std::size_t kBeginningBytesMax = 1024;

/// Rows of a table are numbers; names of columns are not. Saves opening a table at every row.
bool may_be_header(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\"");
  if (first == std::string_view::npos) return false;
  const char letter = line[first];
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_';
}

}  // namespace

/// A table whose header was read. It is not moved, since its parts refer to each other.
struct LiveReader::Table {
  Table(std::string header_line, CsvReader opened, std::unique_ptr<Format> found)
      : header(std::move(header_line)), csv(std::move(opened)), format(std::move(found)) {}

  std::string header;
  std::string note;  ///< as it was said
  CsvReader csv;
  std::unique_ptr<Format> format;
  Observation row;
  FaceNames names;
  double largest = 0;
  double scale = 1;
  bool clocked = false;  ///< some row had a time
};

LiveReader::LiveReader(std::string file, LiveOptions options, LoadCurves load_curves)
    : file_(std::move(file)),
      options_(std::move(options)),
      load_curves_(std::move(load_curves)),
      splitter_(kCsvLineBytesMax),
      timeline_(options_.rate, options_.conditioning),
      clock_(options_.recording.fps, kRefusalsMax),
      face_(options_.recording.face) {}

LiveReader::~LiveReader() = default;
LiveReader::LiveReader(LiveReader&&) noexcept = default;
LiveReader& LiveReader::operator=(LiveReader&&) noexcept = default;

void LiveReader::feed(std::string_view bytes, SteadyTime now) {
  splitter_.feed(bytes);
  for (LineSplitter::Line& line : look_ahead()) read_line(line, now);
  while (auto line = splitter_.next()) read_line(*line, now);
}

/// The first lines, as many as have come at once. Labels such as "1,0" are AUs as well: the first
/// two would be played before the third tells what they are, as they are where lines come one by
/// one. A line that is alone is not kept waiting: it may be all that a live stream has to say.
std::vector<LineSplitter::Line> LiveReader::look_ahead() {
  std::vector<LineSplitter::Line> lines;
  if (table_ || text_ || labels_ || beginning_lines_ > 0) return lines;
  std::string text;
  while (lines.size() < kBeginningLines) {
    auto line = splitter_.next();
    if (!line) break;
    text += line->text.substr(0, kBeginningBytesMax) + '\n';
    lines.push_back(std::move(*line));
  }
  labels_ = label_file(text);
  return lines;
}

void LiveReader::end_input(SteadyTime now) {
  if (splitter_.drop_partial()) complain(file_ + ": the last line has no end and was left out");
  if (arrived_ && !silent_since_) silent_since_ = now;
  clock_.restart();
  timeline_.restart();
}

void LiveReader::restart() {
  splitter_.restart();
  table_.reset();
  text_ = false;
  beginning_.clear();
  beginning_lines_ = 0;
  labels_.reset();
  clock_.restart();
  timeline_.restart();
}

void LiveReader::idle(SteadyTime now) {
  if (silent_since_) timeline_.idle(seconds(now - *silent_since_));
}

std::optional<SteadyTime> LiveReader::idle_due() const {
  const auto due = timeline_.idle_due_seconds();
  if (!due || !silent_since_) return std::nullopt;
  return *silent_since_ + Seconds(*due);
}

void LiveReader::hold_off(SteadyTime now) {
  if (silent_since_) silent_since_ = std::max(*silent_since_, now);
}

std::vector<LiveMessage> LiveReader::take_messages() {
  return std::exchange(messages_, {});
}

void LiveReader::say_of_run(bool warning, std::string text) {
  ++complaints_;
  understood_ = 0;
  if (complaints_ <= kSaidMax) messages_.push_back({warning, std::move(text)});
  if (complaints_ == kSaidMax) {
    messages_.push_back({true, file_ + ": more of this kind is left out without a word"});
  }
}

/// One good line does not end a run of bad ones, or they would fill the log.
void LiveReader::understood() {
  if (++understood_ >= kRunEnds) complaints_ = 0;
}

void LiveReader::read_line(LineSplitter::Line& line, SteadyTime now) {
  if (line.number == 1 && line.text.starts_with(kByteOrderMark)) {
    line.text.erase(0, kByteOrderMark.size());
  }
  if (line.too_long) {
    complain(at_place(
        file_, line.number, kCsvLineBytesMax + 1,
        "the line is longer than " + std::to_string(kCsvLineBytesMax) + " bytes; it was left out"));
    return;
  }
  if (trimmed(line.text, kBlanks).empty() || (!text_ && is_preamble(line.text))) return;
  if (trimmed(line.text, kBlanks) == protocol::kBeginTag && table_) {
    table_.reset();
    timeline_.restart();
  }
  if (may_be_header(line.text) && begin_table(line)) return;
  if (table_) {
    read_row(line, now);
  } else if (is_no_text(line)) {
    complain(at_place(file_, line.number, 1, *labels_));
  } else if (!read_text(line, now) && !text_ && complaints_ <= kSaidMax) {
    say(file_ + ": waiting for the names of columns, or for lines of a stream file");
  }
}

/// True when the line names the columns of a recogniser: a table begins, or begins again.
bool LiveReader::begin_table(const LineSplitter::Line& line) {
  if (table_ && trimmed(line.text, kBlanks) == trimmed(table_->header, kBlanks)) {
    say_of_run(false,
               at_place(file_, line.number, 0, "the header once more: another recording begins"));
    clock_.restart();
    timeline_.restart();
    return true;
  }
  const ContentKind kind = content_kind(line.text);
  if (kind == ContentKind::StreamFile) return false;
  if (kind == ContentKind::Unknown) {
    if (!table_) complain(at_place(file_, line.number, 1, unknown_reason(line.text)));
    return false;
  }
  auto csv = CsvReader::open(line.text, file_);
  if (!csv) return false;
  auto format = open_format(*csv, load_curves_);
  if (!format) {
    complain(format.error().message);
    return false;
  }
  const bool another = table_ || text_;
  if (another) {
    clock_.restart();
    timeline_.restart();
  }
  text_ = false;
  table_ = std::make_unique<Table>(line.text, std::move(*csv), std::move(*format));
  table_->scale =
      options_.recording.au_scale.value_or(scale_for(table_->format->native_scale(), 0));
  table_->note = table_->format->note();
  std::string found = file_ + ": " + std::string(table_->format->name()) +
                      (table_->note.empty() ? "" : " (" + table_->note + ")") +
                      ", live, AU scale 0-" + std::to_string(static_cast<int>(table_->scale));
  another ? say_of_run(false, std::move(found)) : say(std::move(found));
  return true;
}

/// True when the lines so far are labels of a database, which look like lines of a stream file.
bool LiveReader::is_no_text(const LineSplitter::Line& line) {
  if (!labels_ && beginning_lines_ < kBeginningLines) {
    ++beginning_lines_;
    beginning_ += line.text.substr(0, kBeginningBytesMax) + '\n';
    labels_ = label_file(beginning_);
  }
  return labels_.has_value();
}

/// False when the line is not one of a stream file.
bool LiveReader::read_text(const LineSplitter::Line& line, SteadyTime now) {
  const std::string_view content =
      trimmed(std::string_view(line.text).substr(0, line.text.find('#')), kBlanks);
  if (content.empty()) return true;
  if (content == protocol::kBeginTag || content == protocol::kEndTag) {
    text_ = true;
    understood();
    if (content == protocol::kEndTag && arrived_) silent_since_ = now;
    return true;
  }
  protocol::Keyframe keyframe;
  if (content.size() > protocol::kStreamLineBytesMax) {
    complain(at_place(file_, line.number, 1, "the line is too long for a stream file's"));
    return false;
  }
  if (const auto error = protocol::parse_stream_line(content, keyframe)) {
    const auto shift = static_cast<std::size_t>(content.data() - line.text.data());
    complain(at_place(file_, line.number, shift + error->position + 1,
                      error->reason + "; the line was left out"));
    return false;
  }
  if (!text_) say(file_ + ": lines of a stream file, live");
  text_ = true;
  understood();
  play_text(keyframe, now);
  return true;
}

/// The face begins to move to a line's keyframe when the line comes, as in a stream file that is
/// sent live.
void LiveReader::play_text(const protocol::Keyframe& keyframe, SteadyTime now) {
  timeline_.set_clocked(false);
  std::uint32_t time_ms = keyframe.time_ms.value_or(0);
  if (!keyframe.time_ms) {
    const Seconds longest = Milliseconds(options_.keyframe_ms);
    const Seconds step = std::min(arrival_step(now, longest), longest);
    time_ms = static_cast<std::uint32_t>(std::max(1.0, std::round(1000 * seconds(step))));
  }
  arrived_ = now;
  silent_since_.reset();
  timeline_.add(unclocked_, frame_from_terms(keyframe.terms), time_ms);
  unclocked_ += time_ms / 1000.0;
}

/// The time since the last sample; `usual` for one that came together with it.
Seconds LiveReader::arrival_step(SteadyTime now, Seconds usual) {
  if (!arrived_ || now - *arrived_ < kAtOnce) return usual;
  return now - *arrived_;
}

void LiveReader::read_row(const LineSplitter::Line& line, SteadyTime now) {
  CsvReader& csv = table_->csv;
  const auto next = csv.take(line.text, line.number);
  if (next == CsvReader::Next::Row) {
    table_->row.clear();
    table_->format->scan_live(csv);
    table_->format->read(csv, table_->row);
    if (!csv.has_errors()) {
      if (take_row(line.text, now)) understood();
      return;
    }
  }
  for (std::string& reason : csv.take_errors()) complain(reason + "; the row was left out");
}

/// False when the row was left out, with a message.
bool LiveReader::take_row(const std::string& line, SteadyTime now) {
  if (std::string note = table_->format->note(); note != table_->note) {
    say_of_run(false, at_place(file_, table_->csv.line(), 0, note + " from now on"));
    table_->note = std::move(note);
  }
  const bool sure = is_sure(table_->row, options_.recording.confidence_min);
  const std::int64_t face = table_->names.of(table_->row);
  if (sure) note_face(face, line);
  if (!is_chosen(face, sure, now)) return true;
  const auto time = seconds_of_row(now);
  if (!time) {
    complain(at_place(file_, table_->csv.line(), 0,
                      "the row's time is not later than the last; the row was left out"));
    return false;
  }
  if (sure) settle_scale();
  if (table_->clocked && clock_.was_set()) {
    timeline_.restart();
    say_of_run(true, at_place(file_, table_->csv.line(), 0,
                              "the source's clock was set; it goes on from here"));
  }
  arrived_ = now;
  silent_since_ = now;
  timeline_.add(*time, update_of(table_->row, table_->scale, sure));
  return true;
}

/// Once kFacesReadMax faces were reported, others are not.
void LiveReader::note_face(std::int64_t id, const std::string& line) {
  if (!options_.recording.all_faces || faces_seen_.size() >= kFacesReadMax) return;
  if (!faces_seen_.insert(id).second) return;
  new_faces_.push_back({id, table_->header + '\n' + line + '\n'});
}

/// The face that was asked for, or the first one that is seen, until it is gone.
bool LiveReader::is_chosen(std::int64_t id, bool sure, SteadyTime now) {
  if (options_.recording.face) return id == *face_;
  if (!face_ || (id != *face_ && sure && seconds(now - face_seen_) > kHoldSeconds + kEaseSeconds)) {
    if (face_) say_of_run(false, file_ + ": face " + std::to_string(id) + " from now on");
    face_ = id;
  }
  if (id != *face_) return false;
  if (sure) face_seen_ = now;
  return true;
}

/// Sets the scale by the largest value so far. It can only grow, and a message says so when it
/// does.
void LiveReader::settle_scale() {
  for (const AuValue& au : table_->row.aus) {
    if (fits_no_scale(au)) {
      complain(at_place(file_, table_->csv.line(), 0,
                        "AU " + std::to_string(au.number) +
                            " is above 100, which no scale has; the value was left out"));
    } else if (au.native) {
      table_->largest = std::max(table_->largest, au.value);
    }
  }
  if (options_.recording.au_scale) return;
  const double scale = scale_for(table_->format->native_scale(), table_->largest);
  if (scale == table_->scale) return;
  table_->scale = scale;
  timeline_.forget_neutral();
  say_of_run(false, at_place(file_, table_->csv.line(), 0,
                             "AU scale 0-" + std::to_string(static_cast<int>(scale)) +
                                 " from now on; --au-scale says so from the beginning"));
}

std::optional<double> LiveReader::seconds_of_row(SteadyTime now) {
  table_->clocked = table_->clocked || table_->row.seconds || options_.recording.fps;
  timeline_.set_clocked(table_->clocked);
  if (table_->clocked) return clock_.seconds_of(table_->row);
  unclocked_ += seconds(arrival_step(now, kRow));
  return unclocked_;
}

}  // namespace aucast::sources
