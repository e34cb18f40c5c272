#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/check.h"

namespace aucast::protocol {

/// Encoded packets one after the other in one buffer. Each takes its own bytes and four more for
/// its position; positions of four bytes limit the packets to 4 GiB in all.
class PacketList {
 public:
  void push_back(std::string_view packet) {
    AUCAST_CHECK(packet.size() <= UINT32_MAX - bytes_.size());
    bytes_ += packet;
    ends_.push_back(static_cast<std::uint32_t>(bytes_.size()));
  }

  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] bool empty() const { return ends_.empty(); }
  /// Bytes of all packets.
  [[nodiscard]] std::size_t bytes() const { return bytes_.size(); }
  /// The view is valid until the list changes.
  [[nodiscard]] std::string_view operator[](std::size_t index) const {
    const std::size_t begin = index == 0 ? 0 : ends_[index - 1];
    return std::string_view(bytes_).substr(begin, ends_[index] - begin);
  }

  friend bool operator==(const PacketList&, const PacketList&) = default;

 private:
  std::string bytes_;
  std::vector<std::uint32_t> ends_;
};

}  // namespace aucast::protocol
