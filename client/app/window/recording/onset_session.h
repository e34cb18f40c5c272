#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "client/app/window/recording/onset_log.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// The table of onsets (OnsetLog) that the window writes, if it writes one. Thread: the player's.
class OnsetSession {
 public:
  /// From now on, logs in this file what is shown. Finishes the previous file first.
  [[nodiscard]] Result<void> begin(const std::filesystem::path& file);
  /// Adds a face that had moved, as OnsetLog::add(); does nothing if no table is written.
  void add(Instant shown, const FaceShown& face);
  /// Completes the file. Succeeds if there is none.
  [[nodiscard]] Result<void> end();
  /// The file that is being written; empty: none.
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::unique_ptr<OnsetLog> log_;
  std::string file_;
};

}  // namespace aucast::app
