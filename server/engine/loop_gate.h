#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include <asio/io_context.hpp>

#include "server/engine/bus.h"

namespace aucast::server {

/// What the library tells: to the bus' owner, and to the bus itself.
struct LibraryEvents {
  Bus::Events owner;
  /// The connection of this number is closed for good.
  std::function<void(int connection, const std::string& why)> on_given_up;
};

/// The way from the threads of a library to our event loop: what is posted is carried out there, in
/// its order, until the gate is closed. Whoever may still call holds it.
/// Thread: post() any; close() that of the loop.
class LoopGate : public std::enable_shared_from_this<LoopGate> {
 public:
  using Work = std::function<void(const LibraryEvents&)>;
  /// What waits for the loop; more is dropped, and is seen as a hole by its receiver.
  static constexpr std::size_t kBytesMax = std::size_t{4} << 20U;

  LoopGate(asio::io_context& io, LibraryEvents events) : io_(&io), events_(std::move(events)) {}

  /// `bytes`: that the work holds.
  void post(Work work, std::size_t bytes);
  /// Nothing is carried out any more, and the loop is not touched again.
  void close();
  [[nodiscard]] bool is_open();

 private:
  /// True: it is to be carried out.
  [[nodiscard]] bool take(std::size_t bytes);

  std::mutex mutex_;
  asio::io_context* io_;           ///< null: closed
  std::size_t waiting_bytes_ = 0;  ///< guarded by mutex_, as is io_
  const LibraryEvents events_;
};

}  // namespace aucast::server
