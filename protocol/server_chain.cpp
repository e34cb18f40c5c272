#include "protocol/server_chain.h"

#include <algorithm>

#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::protocol {

bool is_server_id(std::string_view text) {
  return text.size() <= kServerIdBytesMax && is_stream_name(text);
}

bool is_server_chain(std::string_view text) {
  if (servers_in(text) > kRelayHopsMax) return false;
  const auto ids = split(text, ',');
  return std::all_of(ids.begin(), ids.end(), is_server_id);
}

std::size_t servers_in(std::string_view chain) {
  if (chain.empty()) return 0;
  return static_cast<std::size_t>(std::count(chain.begin(), chain.end(), ',')) + 1;
}

bool passes_through(std::string_view chain, std::string_view id) {
  const auto ids = split(chain, ',');
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

std::string chained(std::string chain, std::string_view id) {
  if (!chain.empty()) chain += ',';
  return chain.append(id);
}

}  // namespace aucast::protocol
