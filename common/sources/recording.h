#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "common/sources/arkit_table.h"
#include "common/sources/conditioning.h"
#include "common/sources/loud_aus.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// The names of settings as the user sees them, for messages.
struct SettingNames {
  std::string_view fps = "--fps";
  std::string_view neutral = "--neutral";
  friend bool operator==(const SettingNames&, const SettingNames&) = default;
};

/// What the user decides about recordings; the rest is detected.
struct RecordingOptions {
  std::optional<double> fps;         ///< a row's time is its picture's number / fps, (0, 1000]
  std::optional<double> au_scale;    ///< 1, 5 or 100: what full intensity is in the file
  std::optional<std::int64_t> face;  ///< which of several; nullopt: the most frequent
  bool all_faces = false;            ///< each face is a stream of its own
  double confidence_min = 0.5;       ///< [0,1]; a row with less confidence has no data
  SettingNames names;
  friend bool operator==(const RecordingOptions&, const RecordingOptions&) = default;
};

/// If there are more rows a second than this, the times are taken to be wrong or in other units.
inline constexpr double kRowsASecondMax = 250;

/// What was found in a recording.
struct Found {
  struct Face {
    std::int64_t id = 0;
    std::size_t rows = 0;
  };

  std::string format;
  std::string note;          ///< what the format's reader decided or assumed
  double scale = 1;          ///< full intensity: 1, 5 or 100
  bool scale_asked = false;  ///< `scale` was set by --au-scale
  /// The largest AU value in the file; nullopt: its values are read as intensities, without a
  /// scale.
  std::optional<double> largest;
  std::size_t off_scale = 0;  ///< AU values that fit no scale, and count as no data
  std::vector<Face> faces;    ///< in order of appearance
  std::int64_t face = 0;      ///< the one that was taken
  bool all_taken = false;     ///< `face` is one of several that were taken
  std::size_t rows = 0;       ///< of that face
  std::size_t lost = 0;       ///< of `rows`: not tracked, not sure, or without any AU
  std::size_t left_out = 0;   ///< of `rows`: no time, not ascending, same millisecond
  std::size_t headers = 0;    ///< repeated in the middle
  bool truncated = false;     ///< the last line had no end and was not counted
  std::size_t gaps = 0;       ///< stretches longer than kHoldSeconds without a sure row
  double gap_seconds_max = 0;
  double steps_a_second = 0;               ///< 1 / usual time between rows; 0 if there is one row
  double rows_a_second = 0;                ///< mean over the recording; 0 if there is one row
  std::optional<MeasuredNeutral> neutral;  ///< if it was asked for
  std::vector<LoudAu> not_neutral;         ///< AUs that were subtracted as `neutral`, but are too
                                           ///< strong or move too far for a neutral face
  std::optional<double> neutral_seconds;  ///< a value of --neutral that avoids these; nullopt: none
};

/// A recording as keyframes.
struct Recording {
  protocol::StreamFile stream;
  Found found;
};

/// How many faces read_faces() returns at most; further ones are counted in Found::faces only.
inline constexpr std::size_t kFacesReadMax = 64;

/// Reads a recogniser's recording from `text` in two passes, row by row, however many faces it has;
/// measuring for `conditioning` takes one more pass over the first seconds of the faces, and
/// another pass if a face is not neutral in them. This function does not apply the dead band of
/// `conditioning`. `file` is what messages call the recording. `load_curves` loads what a table of
/// ARKit's curves needs. Returns one recording or, with options.all_faces, one for each face that
/// has data, the most frequent first, at most kFacesReadMax. The times of all are those of the
/// file, so that faces seen together play together: a face that comes late is neutral until then.
/// Fails with BadData and one line file:line:column for each of the first 20 errors, or with Usage
/// if --fps is needed, --face-id names no face of the file, or no row shows a face. If asked to
/// stop, returns stopped_early() at the next row.
[[nodiscard]] Result<std::vector<Recording>> read_faces(
    std::string_view text, std::string_view file, const RecordingOptions& options,
    const ConditioningSettings& conditioning = {}, const LoadCurves& load_curves = load_arkit_table,
    const std::stop_token& stop = {});

}  // namespace aucast::sources
