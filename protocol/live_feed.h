#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/changes.h"
#include "protocol/live_clock.h"
#include "protocol/server_session.h"

namespace aucast::protocol {

/// A live stream whose keyframes are made elsewhere and come one by one: each is the newest moment
/// as soon as it is there. Each stream that is fed holds the newest only, encoded once per level.
/// Thread: none of its own.
class LiveFeed final : public LiveTime {
 public:
  /// `classic_min` as in encode_classic().
  LiveFeed(std::uint32_t keyframe_ms, int classic_min);
  LiveFeed(const LiveFeed&) = delete;
  LiveFeed& operator=(const LiveFeed&) = delete;

  /// Feeds the stream from now on, as long as others hold it; its sessions go by this clock, which
  /// must outlive them. Several may be: catalogues that were read at different times.
  void attach(const std::shared_ptr<ServedStream>& stream);
  /// The next moment, a full keyframe. A stream that had ended goes on.
  void add(const Keyframe& keyframe);
  /// Nothing more comes for now: who is there gets {-2}.
  void end() { ended_ = true; }

  [[nodiscard]] const std::optional<LiveMoment>& newest() const override { return newest_; }
  [[nodiscard]] std::span<const LiveMoment> passed() const override {
    return {newest_ ? &*newest_ : nullptr, newest_ ? 1U : 0U};
  }
  [[nodiscard]] bool ended() const override { return ended_; }
  /// By what came lately.
  [[nodiscard]] std::size_t moments_in(Milliseconds time) const override;

 private:
  void show(ServedStream& stream) const;

  std::vector<std::weak_ptr<ServedStream>> streams_;
  std::string classic_;
  std::string full_;
  std::string changed_;
  std::uint32_t keyframe_ms_;
  int classic_min_;
  ChangesEncoder changes_;
  double usual_ms_ = 33;  ///< between two moments
  std::optional<LiveMoment> newest_;
  bool ended_ = false;
};

}  // namespace aucast::protocol
