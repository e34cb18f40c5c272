#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "common/action_unit.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// Logs when each face was on the display, for experiments: a table with a row for each picture in
/// which the face had moved. Columns: monotonic_s, CLOCK_MONOTONIC in seconds after the picture was
/// handed to the display; keyframe, from 1, or 0 if nothing plays; aus, those shown, as in a
/// packet, empty if the face is made of muscles. The file appears with finish(); until then the
/// rows are in a temporary file beside it.
class OnsetLog {
 public:
  [[nodiscard]] static Result<std::unique_ptr<OnsetLog>> create(const std::filesystem::path& path);
  /// Finishes the file if that has not been done, so that the rows of a run that failed are kept.
  ~OnsetLog();
  OnsetLog(const OnsetLog&) = delete;
  OnsetLog& operator=(const OnsetLog&) = delete;

  void add(Instant shown, std::uint64_t keyframe, const std::optional<AuFrame>& aus);
  /// Call it once. Fails if a row could not be written.
  [[nodiscard]] Result<void> finish();

 private:
  OnsetLog(std::filesystem::path path, std::filesystem::path temporary);

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream rows_;
  bool finished_ = false;
};

}  // namespace aucast::app
