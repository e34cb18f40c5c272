#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/steady_timer.hpp>

#include "common/result.h"

namespace aucast::server {

/// The bytes of a source that is still being written: stdin (the path "-"), a FIFO, which is opened
/// again whenever its writer has gone, or a growing file. A file that got shorter, was replaced or
/// was changed where it had been read is read again from its beginning. A read error is reported
/// once; a FIFO and a growing file are tried again, anything else has ended.
/// Thread: that of the io_context, which must outlive it.
class LiveInput {
 public:
  struct Events {
    std::function<void(std::string_view)> on_bytes;
    std::function<void()> on_caught_up;  ///< a growing file was read to its present end
    std::function<void()> on_end;        ///< whoever wrote has gone
    std::function<void(const std::string& why)> on_anew;
  };

  /// Opens something else than the path: a descriptor that can be waited for. When it ends, nothing
  /// more comes.
  using Opener = std::function<Result<int>()>;

  /// `follow`: a regular file is read on when it grows. `open`: if not empty, opens the input in
  /// place of the path.
  LiveInput(asio::io_context& io, std::filesystem::path path, bool follow, Events events,
            Opener open = {});
  ~LiveInput();
  LiveInput(const LiveInput&) = delete;
  LiveInput& operator=(const LiveInput&) = delete;

  /// Opens it and begins to read. Unreadable, with the system's reason.
  [[nodiscard]] Result<void> start();
  /// Nothing is read for now, or again.
  void hold(bool held);
  void stop();
  /// True for a file, which may already hold something; what comes through a pipe is new.
  [[nodiscard]] bool has_past() const { return file_ >= 0; }
  /// Nothing comes any more: stdin has ended, or a FIFO cannot be opened again.
  [[nodiscard]] bool ended() const { return ended_; }
  /// Why the last read failed; nullopt if it did not.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

 private:
  [[nodiscard]] Result<int> open_path() const;
  void take(int descriptor);
  void watch();
  void await();
  void read_stream();
  void stream_ended();
  void read_file();
  void look_again();
  [[nodiscard]] bool replaced() const;
  [[nodiscard]] std::string changed() const;
  void begin_anew(const std::string& why);
  void pass_on(std::string_view bytes);
  [[nodiscard]] Error unreadable() const;
  void note_failure(Error failure);

  asio::io_context& io_;
  std::filesystem::path path_;
  bool follow_;
  Events events_;
  Opener open_;
  asio::posix::stream_descriptor stream_;  ///< of what can be waited for
  asio::posix::stream_descriptor notify_;  ///< inotify, of a growing file
  asio::steady_timer timer_;
  int file_ = -1;  ///< of what cannot
  std::int64_t position_ = 0;
  std::string tail_;  ///< the last bytes that were read, to see whether they changed
  std::vector<char> chunk_;
  bool held_ = false;
  bool stopped_ = false;
  bool waiting_ = false;
  bool ended_ = false;
  std::optional<Error> failure_;
  /// Cleared on destruction; handlers that still come see it.
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace aucast::server
