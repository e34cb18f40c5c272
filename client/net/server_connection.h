#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "client/net/au_reader.h"
#include "common/link/link.h"
#include "common/time.h"

namespace aucast::net {

/// The one object that the player's and the network thread both touch.
class SharedReader {
 public:
  explicit SharedReader(AuReaderOptions options) : reader_(std::move(options)) {}

  /// Calls `act` with the reader while nobody else has it.
  template <typename Act>
  auto with(Act act) {
    const std::lock_guard lock(mutex_);
    return act(reader_);
  }
  /// Waits until the reader is ready() or until `until`; returns ready().
  [[nodiscard]] bool wait_until(Instant until) {
    std::unique_lock lock(mutex_);
    return news_.wait_until(lock, until, [this] { return reader_.ready(); });
  }
  void notify() { news_.notify_all(); }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  AuReader reader_;  // guarded by mutex_
};

/// Carries out on links what an AuReader decides: one link after the other, when connections are
/// lost. Who makes the links is the owner's business, and so is the wait before the next one.
/// Thread: that of the links; the reader is shared with the player's.
class ServerConnection final : public link::LinkUser {
 public:
  /// What the connection wants of its owner.
  struct Owner {
    std::function<void(Milliseconds wait)> dial;  ///< a link, after so long: begin() or fail()
    std::function<void()> over;                   ///< nothing more will be wanted
    std::function<void()> changed;                ///< there is something new for the player
  };

  /// `peer`: HOST:PORT, for messages.
  ServerConnection(SharedReader& reader, std::string peer, Owner owner);
  ~ServerConnection() override;
  ServerConnection(const ServerConnection&) = delete;
  ServerConnection& operator=(const ServerConnection&) = delete;

  void begin(std::shared_ptr<link::Link> link);
  /// No link could be made. `final`: another attempt would not change it.
  void fail(const std::string& reason, bool final);
  /// The player has done something that may give the reader something to say.
  void speak(Instant now);
  /// The user leaves: the last words, then over().
  void leave();

  /// Answers so far, as the protocol has them. Any thread.
  [[nodiscard]] std::uint64_t bytes_sent() const { return bytes_sent_; }

 private:
  void on_open() override;
  void on_bytes(std::string_view bytes) override;
  void on_peer_end() override;
  void on_room() override {}
  void on_time() override;
  void on_closed(const link::Ending& ending) override;

  void lose(std::string broke);
  void carry_out(const Reaction& reaction);
  void send(std::string_view words);
  void drop_link();

  SharedReader& reader_;
  const std::string peer_;
  const Owner owner_;
  std::shared_ptr<link::Link> link_;  ///< nothing: none is there
  bool open_ = false;
  bool link_over_ = false;   ///< it closed by itself; what it brought may still wait for room
  bool peer_ended_ = false;  ///< and the reader has not been told yet
  std::string broke_;        ///< why it did; empty: the peer shut its side
  bool leaving_ = false;
  bool over_ = false;
  std::atomic<std::uint64_t> bytes_sent_{0};
};

}  // namespace aucast::net
