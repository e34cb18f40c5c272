#include "protocol/server_chain.h"

#include <algorithm>

#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

/// Calls `visit` with each ID until it returns false; returns whether it never did.
template <typename Visit>
bool for_each_id(std::string_view chain, Visit visit) {
  while (true) {
    const std::size_t comma = std::min(chain.find(','), chain.size());
    if (!visit(chain.substr(0, comma))) return false;
    if (comma == chain.size()) return true;
    chain.remove_prefix(comma + 1);
  }
}

}  // namespace

bool is_server_id(std::string_view text) {
  return text.size() <= kServerIdBytesMax && is_stream_name(text);
}

bool is_server_chain(std::string_view text) {
  return servers_in(text) <= kRelayHopsMax && for_each_id(text, is_server_id);
}

std::size_t servers_in(std::string_view chain) {
  if (chain.empty()) return 0;
  return static_cast<std::size_t>(std::count(chain.begin(), chain.end(), ',')) + 1;
}

bool passes_through(std::string_view chain, std::string_view id) {
  return !for_each_id(chain, [id](std::string_view server) { return server != id; });
}

std::string chained(std::string chain, std::string_view id) {
  if (!chain.empty()) chain += ',';
  return chain.append(id);
}

}  // namespace aucast::protocol
