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

/// When each face was on the display, for the clock of an experiment: a table with a row for each
/// picture in which the face had moved. monotonic_s is CLOCK_MONOTONIC after the picture was handed
/// to the display, in seconds; keyframe counts from 1, 0 when nothing plays; aus are those shown at
/// this moment, as in a packet, empty when the face is made of muscles.
/// The file is there when finish() has been called; until then its rows are in one beside it.
class OnsetLog {
 public:
  [[nodiscard]] static Result<std::unique_ptr<OnsetLog>> create(const std::filesystem::path& path);
  /// Finishes it, when nobody has: what was shown of a run that failed is kept.
  ~OnsetLog();
  OnsetLog(const OnsetLog&) = delete;
  OnsetLog& operator=(const OnsetLog&) = delete;

  void add(Instant shown, std::uint64_t keyframe, const std::optional<AuFrame>& aus);
  /// Once. Failed when a row could not be written.
  [[nodiscard]] Result<void> finish();

 private:
  OnsetLog(std::filesystem::path path, std::filesystem::path temporary);

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream rows_;
  bool finished_ = false;
};

}  // namespace aucast::app
