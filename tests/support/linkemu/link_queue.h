#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <string>

#include "common/time.h"

namespace aucast::linkemu {

/// What a link does to packets, in each direction alike.
struct Quality {
  double delay_ms = 0;
  double jitter_ms = 0;             ///< up to so much more or less than the delay; order is kept
  double loss_percent = 0;          ///< of all packets
  double burst = 1;                 ///< losses in a row, on the average
  double kilobits = 0;              ///< a second; 0: as fast as they come
  std::size_t queue_bytes = 65536;  ///< how much may wait to be sent; more is lost
};

/// One direction of an emulated link. Pure: time is handed in, the seed decides chance.
class LinkQueue {
 public:
  LinkQueue(const Quality& quality, std::uint64_t seed) : quality_(quality), chance_(seed) {}

  void put(std::string packet, Instant now);
  /// The next packet that has arrived by `now`.
  [[nodiscard]] std::optional<std::string> take(Instant now);
  /// When take() will return a packet; nullopt while the link is empty.
  [[nodiscard]] std::optional<Instant> next_at() const;
  /// A link that is down loses what is put in and what is on its way.
  void set_down(bool down);

  [[nodiscard]] std::uint64_t passed() const { return passed_; }
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// The most packets that were lost by chance in a row.
  [[nodiscard]] std::uint64_t longest_loss() const { return longest_; }
  [[nodiscard]] std::uint64_t too_many() const { return too_many_; }  ///< lost to a full queue

 private:
  struct Packet {
    Instant due;
    Instant sent;  ///< when it has left the queue for the wire
    std::string bytes;
  };

  [[nodiscard]] bool loses_one();
  [[nodiscard]] std::size_t waiting_bytes(Instant now) const;
  [[nodiscard]] double random() { return std::uniform_real_distribution<double>(0, 1)(chance_); }

  Quality quality_;
  std::mt19937_64 chance_;
  std::deque<Packet> packets_;
  Instant free_at_{};
  bool losing_ = false;
  bool down_ = false;
  std::uint64_t passed_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t run_ = 0;  ///< lost in a row just now
  std::uint64_t longest_ = 0;
  std::uint64_t too_many_ = 0;
};

}  // namespace aucast::linkemu
