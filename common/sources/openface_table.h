#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "protocol/stream_file.h"

namespace aucast::sources {

/// The longest time between two rows of a written table. Readers conclude from a longer time that
/// rows are missing.
inline constexpr std::uint32_t kRowMsMax = 100;

/// A stream as a table.
struct OpenFaceTable {
  std::string text;
  std::size_t rows = 0;
  std::size_t uneven = 0;  ///< keyframes whose sides differ: the stronger side is written
};

/// Writes the stream as OpenFace 2 would have recorded it, with one face. Each keyframe has a row
/// at the time when it is reached (an untimed one takes `keyframe_ms`). Where two of these rows are
/// more than kRowMsMax apart, interpolated rows come between. Of keyframes reached in the same
/// millisecond only the last has a row. AUs 51-56 and 61-64 become pose and gaze, 57 and 58 a
/// distance around 600 mm (read with --distance), everything else AUnn_r from 0 to 5, including AUs
/// that OpenFace does not know. Read again as a recording, the table gives keyframes of the same
/// percents.
[[nodiscard]] OpenFaceTable write_openface_table(const protocol::StreamFile& stream,
                                                 std::uint32_t keyframe_ms);

}  // namespace aucast::sources
