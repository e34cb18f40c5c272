#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/steady_timer.hpp>

#include "common/descriptor.h"
#include "server/live/input_reader.h"

namespace aucast::server {

/// Reads a regular file, or another input that epoll cannot wait for, to its end. With `follow` it
/// goes on as the file grows, and begins again when the file has got shorter, or has been replaced
/// or changed just before the place that was read last.
/// Thread: that of the io_context.
class FileReader final : public InputReader {
 public:
  /// `file` is read from its present position on. `path`: where to look for one that replaces it;
  /// "-" for stdin, which is never replaced. `follow`: the file may grow.
  FileReader(asio::io_context& io, std::filesystem::path path, Descriptor file, bool follow,
             const Events& events);

  /// Begins to read; watches the file with inotify if possible.
  void start() override;
  void stop() override;
  [[nodiscard]] bool has_past() const override { return true; }

 private:
  [[nodiscard]] bool is_stdin() const { return path_ == "-"; }
  void find_place();
  void watch();
  void watch_file();
  void wait_for_bytes() override;
  void read();
  void look_again();
  void on_look();
  [[nodiscard]] bool replaced() const;
  [[nodiscard]] std::string changed() const;
  [[nodiscard]] bool begin_anew(const std::string& why);
  void pass_on(std::string_view bytes);

  asio::io_context& io_;
  Descriptor file_;
  bool follow_;
  asio::posix::stream_descriptor notify_;  ///< inotify
  int watch_ = -1;                         ///< the file's watch in notify_; negative: none
  asio::steady_timer timer_;
  std::int64_t position_ = 0;
  std::string tail_;  ///< the last bytes that were read, to notice if they change
};

}  // namespace aucast::server
