#pragma once

#include <functional>
#include <optional>
#include <string>

#include "common/link/link.h"

namespace aucast::link::test {

/// Notes what a link tells it.
struct RecordingUser final : LinkUser {
  void on_open() override {
    opened = true;
    if (when_open) when_open();
  }
  void on_bytes(std::string_view bytes) override { heard += bytes; }
  void on_peer_end() override { peer_ended = true; }
  void on_room() override { ++rooms; }
  void on_time() override { ++times; }
  void on_failure(const Ending& why) override { failure = why; }
  void on_closed(const Ending& why) override { ending = why; }

  [[nodiscard]] bool closed_as(Ending::Why why) const { return ending && ending->why == why; }

  bool opened = false;
  std::function<void()> when_open;
  std::string heard;
  bool peer_ended = false;
  int rooms = 0;
  int times = 0;
  std::optional<Ending> failure;
  std::optional<Ending> ending;
};

}  // namespace aucast::link::test
