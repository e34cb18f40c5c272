#pragma once

#include <filesystem>
#include <optional>

#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>

#include "common/descriptor.h"
#include "server/live/input_reader.h"

namespace aucast::server {

/// Reads a pipe, a FIFO, a socket or a terminal until its writer has gone: inputs for which the
/// kernel reports when there is more to read.
/// Thread: that of the io_context.
class PipeReader final : public InputReader {
 public:
  /// Takes the descriptor if the kernel reports when there is more to read. Otherwise leaves it
  /// alone and returns nullopt: files and some devices have to be polled.
  [[nodiscard]] static std::optional<asio::posix::stream_descriptor> take(asio::io_context& io,
                                                                          Descriptor& descriptor);

  /// `path`: for messages.
  PipeReader(asio::posix::stream_descriptor pipe, std::filesystem::path path, const Events& events);

  void start() override { await(); }
  void stop() override;
  [[nodiscard]] bool has_past() const override { return false; }

 private:
  void wait_for_bytes() override;
  void read();
  void fail(int error_number);

  asio::posix::stream_descriptor pipe_;
};

}  // namespace aucast::server
