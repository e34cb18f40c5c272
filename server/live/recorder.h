#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "common/result.h"
#include "common/sources/record_timeline.h"
#include "protocol/packet.h"
#include "server/live/record_file.h"

namespace aucast::server {

/// Keeps a live stream in a file (--record) while it is served. The file is written on a thread of
/// its own, so that a slow disk holds up no client; a full one ends the recording, not the stream.
/// Thread: that of its owner; the members under `mutex_` are shared with the writing thread.
class Recorder {
 public:
  /// As RecordFile::create().
  [[nodiscard]] static Result<std::unique_ptr<Recorder>> start(const std::filesystem::path& path);
  Recorder(std::filesystem::path path, RecordFile file);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// As RecordTimeline has them.
  void add(const protocol::Keyframe& keyframe, double now, bool free);
  void end_of_stream() { timeline_.end(); }
  /// Waits until everything is written. The error that ended the recording, if one did.
  [[nodiscard]] Result<void> finish();

 private:
  void write_until_finished();
  [[nodiscard]] Result<void> write(std::string_view lines);

  std::filesystem::path path_;
  RecordFile file_;          ///< of the writing thread
  std::size_t written_ = 0;  ///< lines; of the writing thread
  sources::RecordTimeline timeline_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string waiting_;         ///< under mutex_: lines to write
  bool finished_ = false;       ///< under mutex_
  std::optional<Error> error_;  ///< under mutex_: what ended the recording
  std::thread thread_;
};

/// The file that a stream is kept in. `record`: what --record says; in a folder each stream gets a
/// file of its own, NAME-20261121T115000Z.txt by the time that it began, else only the `first` one
/// is kept.
[[nodiscard]] std::optional<std::filesystem::path> record_path(const std::filesystem::path& record,
                                                               const std::string& stream,
                                                               bool first);

}  // namespace aucast::server
