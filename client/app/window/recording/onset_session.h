#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "client/app/window/recording/onset_log.h"
#include "common/action_unit.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// The table of onsets that the window writes, if it writes one. Thread: the player's.
class OnsetSession {
 public:
  /// What is shown from now on goes into this file; the one before is finished first.
  [[nodiscard]] Result<void> begin(const std::filesystem::path& file);
  /// A face that had moved was on the display since then (OnsetLog::add()).
  void add(Instant shown, std::uint64_t keyframe, const std::optional<AuFrame>& aus);
  /// The file is complete; done when there is none.
  [[nodiscard]] Result<void> end();
  /// That is being written; empty: none.
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::unique_ptr<OnsetLog> log_;
  std::string file_;
};

}  // namespace aucast::app
