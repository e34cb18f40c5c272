#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

#include "common/action_unit.h"
#include "common/result.h"
#include "common/temporary_file.h"
#include "common/time.h"

namespace aucast::app {

/// What a picture shows.
struct FaceShown {
  std::uint64_t keyframe = 0;  ///< the one under way, from 1; 0: nothing plays
  std::uint64_t reached = 0;   ///< the last one whose face was reached; 0: none. Ignored if nothing
                               ///< plays
  std::optional<AuFrame> aus;  ///< nullopt: the face is made of muscles
};

/// Logs when each face was on the display, for experiments: a table with a row for each picture in
/// which the face had moved. Columns: monotonic_s, CLOCK_MONOTONIC in seconds, read after the
/// picture was handed to the display; keyframe, as in FaceShown; aus, the AUs shown, as in a
/// packet; reached, the number of the keyframe that has ended since the row before ("3-5" if
/// several have), else empty. The file appears with end(); until then the rows are in a temporary
/// file beside it. Thread: the player's.
class OnsetLog {
 public:
  OnsetLog() = default;
  /// Ends the table if that has not been done, so that the rows of a run that failed are kept.
  ~OnsetLog();
  OnsetLog(const OnsetLog&) = delete;
  OnsetLog& operator=(const OnsetLog&) = delete;

  /// From now on, logs in this file what is shown. Ends the previous table first.
  [[nodiscard]] Result<void> begin(const std::filesystem::path& file);
  /// Does nothing if no table is written.
  void add(Instant shown, const FaceShown& face);
  /// Completes the file, if there is one. Fails if a row could not be written.
  [[nodiscard]] Result<void> end();
  /// The file that is being written; empty: none.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  TemporaryFile temporary_;
  std::ofstream rows_;
  std::optional<std::uint64_t> reached_;  ///< as in the last row that was written while something
                                          ///< played
};

}  // namespace aucast::app
