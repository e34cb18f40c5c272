#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "common/sources/arkit_table.h"
#include "common/sources/conditioning.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// What the user decides about recordings; what is not set is found out.
struct RecordingOptions {
  std::optional<double> fps;         ///< the clock is the picture's number by this, (0, 1000]
  std::optional<double> au_scale;    ///< 1, 5 or 100: what full intensity is in the file
  std::optional<std::int64_t> face;  ///< which of several; else the most frequent
  bool all_faces = false;            ///< each as a stream of its own
  double confidence_min = 0.5;       ///< [0,1]; less sure rows are no data
  friend bool operator==(const RecordingOptions&, const RecordingOptions&) = default;
};

/// More rows a second than that are no camera's: the times are in other units, or wrong.
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
  bool scale_asked = false;  ///< by --au-scale
  double largest = 0;        ///< of the file's own AU values
  std::vector<Face> faces;   ///< in order of appearance
  std::int64_t face = 0;     ///< the one that was taken
  bool all_taken = false;    ///< it is one of several streams
  std::size_t rows = 0;      ///< of that face
  std::size_t lost = 0;      ///< of them: not tracked, not sure, or without any AU
  std::size_t left_out = 0;  ///< of them: no time, not ascending, same millisecond
  std::size_t headers = 0;   ///< repeated in the middle
  bool truncated = false;    ///< the last line had no end and was not counted
  std::size_t gaps = 0;      ///< stretches longer than kHoldSeconds without a sure row
  double gap_seconds_max = 0;
  double steps_a_second = 0;               ///< usual steps of the clock; 0 of a single row
  double rows_a_second = 0;                ///< on the recording's clock; 0 of a single row
  std::optional<MeasuredNeutral> neutral;  ///< if it was asked for
};

/// A recording as keyframes.
struct Recording {
  protocol::StreamFile stream;
  Found found;
};

/// Reads a recogniser's recording whole, in two passes that hold one row each. `file` is what
/// messages call it. BadData with one line file:line:column for each of the first 20 errors; Usage
/// when only an option can help (--fps, --face-id). What `conditioning` measures is measured before
/// the first keyframe; its dead band is not applied here. `load_curves`: for tables of ARKit's
/// curves.
[[nodiscard]] Result<Recording> read_recording(std::string_view text, std::string_view file,
                                               const RecordingOptions& options,
                                               const ConditioningSettings& conditioning = {},
                                               const LoadCurves& load_curves = load_arkit_table);

/// More people are not told apart by any tracker; with all_faces the rest is left out and counted.
inline constexpr std::size_t kFacesMax = 64;

/// The same with options.all_faces: one recording for each face that says anything, the most
/// frequent first, kFacesMax at most. Their times are those of the file, so that faces seen
/// together are together: who comes late is neutral until then.
[[nodiscard]] Result<std::vector<Recording>> read_faces(
    std::string_view text, std::string_view file, const RecordingOptions& options,
    const ConditioningSettings& conditioning = {},
    const LoadCurves& load_curves = load_arkit_table);

/// What was found, one line each: "  format      OpenFace 2".
[[nodiscard]] std::string found_lines(const Found& found);
/// The same in a sentence, for the log.
[[nodiscard]] std::string found_sentence(const Found& found);

}  // namespace aucast::sources
