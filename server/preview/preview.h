#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>

#include "common/camera/camera_feed.h"
#include "common/link/loop_gate.h"
#include "common/result.h"
#include "common/shared.h"

namespace aucast::server {

/// Does --preview: writes what the camera sees to standard output, and reads orders from standard
/// input (common/preview). A picture that comes while the previous one is still being written is
/// dropped.
/// Thread: that of the io_context, which must outlive it, except for offer().
class Preview {
 public:
  struct Hooks {
    /// Lets others in at this address. Returns the address with the real port.
    std::function<Result<std::string>(const std::string& bind, std::uint16_t port)> open;
    std::function<void()> close;
    /// How many others are connected.
    std::function<std::size_t()> watching;
    /// The program that started us has gone. Called once.
    std::function<void()> on_gone;
  };

  Preview(asio::io_context& io, Hooks hooks);
  ~Preview() { gate_->close(); }
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// Reads orders from `in` and writes to `out`; makes copies of both descriptors. Fails with
  /// ErrorKind::Failed if one of them is neither a pipe nor a socket.
  [[nodiscard]] Result<void> start(int in = STDIN_FILENO, int out = STDOUT_FILENO);
  void stop();
  /// Writes what the camera sees. From any thread.
  void offer(const camera::Sight& sight);

 private:
  void read();
  void take_orders();
  void carry_out(std::string_view line);
  void write(const std::string& record);
  void write_on();
  void end();

  std::shared_ptr<link::LoopGate> gate_;
  Hooks hooks_;
  asio::posix::stream_descriptor in_;
  asio::posix::stream_descriptor out_;
  std::string chunk_;
  std::string orders_;   ///< bytes that are no whole line yet
  std::string waiting_;  ///< to be written
  std::string written_;  ///< being written now
  std::size_t said_watching_ = 0;
  bool picture_in_waiting_ = false;
  Shared<bool> picture_pending_{false};  ///< from offer() until it was written
  bool gone_ = false;
};

}  // namespace aucast::server
