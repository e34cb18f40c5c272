#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "protocol/stream_file.h"

namespace aucast::sources {

/// The longest time between two rows of a written table: a reader takes longer gaps for missing
/// rows.
inline constexpr std::uint32_t kRowMsMax = 100;

/// A stream as a table.
struct OpenFaceTable {
  std::string text;
  std::size_t rows = 0;
  std::size_t uneven = 0;  ///< keyframes whose sides differ: the stronger side is written
};

/// The stream as OpenFace 2 would have recorded it: one face, a row where each keyframe is reached
/// and rows in straight lines between those that lie further apart (an untimed one takes
/// `keyframe_ms`); of keyframes reached in the same millisecond only the last has a row. AUs 51-56
/// and 61-64 become pose and gaze, 57 and 58 millimetres about 600 (read with --distance),
/// everything else AUnn_r from 0 to 5, also what OpenFace does not know. Read again as a recording,
/// it gives keyframes of the same percents.
[[nodiscard]] OpenFaceTable write_openface_table(const protocol::StreamFile& stream,
                                                 std::uint32_t keyframe_ms);

}  // namespace aucast::sources
