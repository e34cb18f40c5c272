#pragma once

#include <initializer_list>
#include <string_view>

#include "protocol/packet_list.h"

namespace aucast::test {

[[nodiscard]] inline protocol::PacketList packets(std::initializer_list<std::string_view> texts) {
  protocol::PacketList list;
  for (const std::string_view text : texts) list.push_back(text);
  return list;
}

}  // namespace aucast::test
