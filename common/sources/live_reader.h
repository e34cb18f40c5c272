#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/result.h"
#include "common/sources/arkit_table.h"
#include "common/sources/line_splitter.h"
#include "common/sources/live_timeline.h"
#include "common/sources/recording.h"
#include "common/sources/row_reading.h"
#include "common/time.h"
#include "protocol/limits.h"

namespace aucast::sources {

struct LiveOptions {
  RecordingOptions recording;
  std::optional<double> rate;  ///< keyframes a second, at most
  ConditioningSettings conditioning;
  std::uint32_t keyframe_ms =
      protocol::kDefaultKeyframeTime.count();  ///< the most that a line without a time lasts
};

/// A message about a live source, for the log.
struct LiveMessage {
  bool warning = false;
  std::string text;  ///< "file:line:column: reason", or a sentence that begins with the file
};

/// A face that needs its own reader.
struct NewFace {
  std::int64_t id = 0;
  std::string beginning;  ///< to feed to that reader first: the names of the columns, and the
                          ///< face's first row
};

/// Reads a live source byte by byte: a table of any known recogniser, or lines of a stream file;
/// the first line shows which. Labels of a database are told from AUs by the first three lines: if
/// they come one by one, the first two are played. Pure: bytes and times of arrival go in,
/// keyframes and messages come out.
///
/// No input makes the reader fail. A line that is not understood is left out with a message. After
/// kSaidMax messages there are no more until kRunEnds good lines have come in a row. The beginning
/// of a line waits for the rest. A header in the middle (the same, or of another format) begins a
/// new table whose clock goes on from the last sample. A row that is not later than the last sample
/// is left out. When kRefusalsMax rows in succession are left out for this reason, and each is
/// later than the one before it, the reader assumes that the writer's clock was set back, and goes
/// on from the last sample. Rows without a clock (Py-Feat without --fps) and lines without a time
/// take the time since the previous one.
class LiveReader {
 public:
  static constexpr std::size_t kSaidMax = 20;
  static constexpr std::size_t kRunEnds = 100;
  static constexpr std::size_t kRefusalsMax = 10;

  /// `file`: the name of the source in messages. `load_curves` is called once, when the first row
  /// comes that has ARKit's curves.
  LiveReader(std::string file, LiveOptions options, LoadCurves load_curves);
  ~LiveReader();
  LiveReader(LiveReader&&) noexcept;
  LiveReader& operator=(LiveReader&&) noexcept;

  /// Takes bytes that came at `now`.
  void feed(std::string_view bytes, SteadyTime now);
  /// The writer has gone, at least for now: the beginning of an unfinished line is dropped.
  void end_input(SteadyTime now);
  /// The file begins anew: the next line is its first.
  void restart();
  /// Call when idle_due() has come: eases the face to neutral, since its rows no longer come.
  void idle(SteadyTime now);
  [[nodiscard]] std::optional<SteadyTime> idle_due() const;
  /// Since when the source has been silent; nullopt: it is not silent, or has not begun yet. If
  /// the last line was a stream file's, silence begins only at End_Stream or at the end of the
  /// input.
  [[nodiscard]] std::optional<SteadyTime> silent_since() const { return silent_since_; }
  /// Call this when a keyframe is sent at `now`, maybe long after it was read. Silence is then
  /// counted from `now` at the earliest.
  void hold_off(SteadyTime now);

  [[nodiscard]] std::vector<LiveKeyframe> take_keyframes() { return timeline_.take(); }
  [[nodiscard]] std::vector<LiveMessage> take_messages();
  /// With all_faces: the faces first seen since the last call.
  [[nodiscard]] std::vector<NewFace> take_new_faces() { return std::exchange(new_faces_, {}); }
  /// As Conditioning::take_neutral().
  [[nodiscard]] std::optional<MeasuredNeutral> take_neutral() { return timeline_.take_neutral(); }
  /// As Conditioning::change(), from the next row on.
  void condition(const ConditioningSettings& settings) { timeline_.change(settings); }

 private:
  struct Table;

  [[nodiscard]] std::vector<LineSplitter::Line> look_ahead();
  void read_line(LineSplitter::Line& line, SteadyTime now);
  [[nodiscard]] bool begin_table(const LineSplitter::Line& line);
  [[nodiscard]] bool read_text(const LineSplitter::Line& line, SteadyTime now);
  void play_text(const protocol::Keyframe& keyframe, SteadyTime now);
  void read_row(const LineSplitter::Line& line, SteadyTime now);
  [[nodiscard]] bool take_row(const std::string& line, SteadyTime now);
  [[nodiscard]] bool is_no_text(const LineSplitter::Line& line);
  void understood();
  void note_face(std::int64_t id, const std::string& line);
  [[nodiscard]] bool is_chosen(std::int64_t id, bool sure, SteadyTime now);
  void settle_scale();
  [[nodiscard]] std::optional<double> seconds_of_row(SteadyTime now);
  [[nodiscard]] Seconds arrival_step(SteadyTime now, Seconds usual);
  /// Adds a message, unless there were kSaidMax of them since the last kRunEnds good lines.
  void say_of_run(bool warning, std::string text);
  void complain(std::string text) { say_of_run(true, std::move(text)); }
  void say(std::string text) { messages_.push_back({false, std::move(text)}); }

  std::string file_;
  LiveOptions options_;
  LoadCurves load_curves_;
  LineSplitter splitter_;
  std::unique_ptr<Table> table_;  ///< null: lines of a stream file, or not known yet
  bool text_ = false;             ///< lines of a stream file are read
  LiveTimeline timeline_;
  SourceClock clock_;
  double unclocked_ = 0;               ///< seconds by arrival, for a source without a clock
  std::optional<SteadyTime> arrived_;  ///< when the last sample came
  std::optional<SteadyTime> silent_since_;
  std::optional<std::int64_t> face_;  ///< the face that is followed
  SteadyTime face_seen_;
  std::set<std::int64_t> faces_seen_;
  std::vector<NewFace> new_faces_;
  std::string beginning_;  ///< the first lines
  std::size_t beginning_lines_ = 0;
  std::optional<std::string> labels_;  ///< the message if the first lines have labels, not AUs
  std::size_t complaints_ = 0;         ///< since kRunEnds good lines came in a row
  std::size_t understood_ = 0;         ///< lines since the last complaint
  std::vector<LiveMessage> messages_;
};

}  // namespace aucast::sources
