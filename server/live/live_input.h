#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <asio/io_context.hpp>

#include "common/descriptor.h"
#include "common/result.h"
#include "server/live/input_reader.h"

namespace aucast::server {

/// Reads a source that is still being written: stdin (the path "-"), a FIFO, which is opened again
/// whenever its writer has gone, or a growing file. Opens it and chooses its reader; logs only the
/// first of several read errors in a row.
/// Thread: that of the io_context, which must outlive it.
class LiveInput {
 public:
  struct Events {
    std::function<void(std::string_view)> on_bytes;
    std::function<void()> on_caught_up;  ///< a growing file was read to its present end
    std::function<void()> on_end;        ///< the writer has gone
    std::function<void(const std::string& why)> on_anew;
  };

  /// Opens something other than the path, and returns a descriptor that can be waited for. When the
  /// descriptor ends, nothing more comes.
  using Opener = std::function<Result<Descriptor>()>;

  /// `follow`: a regular file is read on when it grows. `open`: if set, opens the input instead of
  /// the path.
  LiveInput(asio::io_context& io, std::filesystem::path path, bool follow, Events events,
            Opener open = {});
  LiveInput(const LiveInput&) = delete;
  LiveInput& operator=(const LiveInput&) = delete;

  /// Opens the input and begins to read. Fails as `open` does or, if that is not set, with
  /// ErrorKind::Unreadable and the system's reason.
  [[nodiscard]] Result<void> start();
  /// With false, stops reading for now; with true, goes on.
  void set_reading(bool reading);
  void stop();
  /// True for a file, which may already have content; what comes through a pipe is new.
  [[nodiscard]] bool has_past() const { return reader_ && reader_->has_past(); }
  /// Whether nothing more can come: stdin has ended, or a FIFO cannot be opened again.
  [[nodiscard]] bool ended() const { return ended_; }
  /// Why the last read failed; nullopt if it did not.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

 private:
  [[nodiscard]] Result<Descriptor> open_path() const;
  void read_from(Descriptor descriptor);
  void on_reader_end();
  void note_failure(Error failure);

  asio::io_context& io_;
  std::filesystem::path path_;
  bool follow_;
  Events events_;
  Opener open_;
  InputReader::Events reader_events_;
  std::unique_ptr<InputReader> reader_;
  bool reading_ = true;
  bool ended_ = false;
  std::optional<Error> failure_;
};

}  // namespace aucast::server
