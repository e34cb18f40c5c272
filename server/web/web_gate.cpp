#include "server/web/web_gate.h"

#include <algorithm>
#include <system_error>

#include "common/link/listener.h"
#include "common/text.h"
#include "common/text_file.h"
#include "common/web/origin.h"
#include "common/web/upgrade.h"
#include "protocol/endpoint.h"

namespace aucast::server {
namespace {

using asio::ip::address;

std::optional<address> address_of(std::string_view text) {
  std::error_code none;
  const address found = asio::ip::make_address(std::string(text), none);
  if (none) return std::nullopt;
  return link::without_mapping(found);
}

bool is_one_of(const address& peer, const std::vector<std::string>& addresses) {
  return std::any_of(addresses.begin(), addresses.end(), [&peer](const std::string& text) {
    return address_of(text) == link::without_mapping(peer);
  });
}

}  // namespace

std::optional<web::HttpReply> refuse_host(const web::HttpRequest& request,
                                          const std::vector<std::string>& names) {
  if (web::is_own_host(request.field("host"), names)) return std::nullopt;
  return web::HttpReply{.status = 421,
                        .body =
                            "this server does not answer for that host: use its IP address, or "
                            "start it with --web-host NAME\n"};
}

std::optional<web::HttpReply> refuse_web_socket(const web::HttpRequest& request,
                                                const std::vector<std::string>& names) {
  if (auto refused = web::refuse_upgrade(request)) return refused;
  if (web::is_own_origin(request.field("origin"), request.field("host"), names)) {
    return std::nullopt;
  }
  return web::HttpReply{.status = 403,
                        .body =
                            "a page of another host may not watch: start this server with "
                            "--web-host and the page's host to let it\n"};
}

Asker asker(const web::HttpRequest& request, const address& peer,
            const std::vector<std::string>& trusted_proxies) {
  Asker from{peer, {}};
  std::vector<std::string_view> hops = split(request.field("x-forwarded-for"), ',');
  // The last was written by the proxy, those before it by whoever it heard them from.
  for (auto hop = hops.rbegin(); hop != hops.rend(); ++hop) {
    if (!is_one_of(from.address, trusted_proxies)) break;
    const std::string_view said = trimmed(*hop, " \t");
    // Some proxies write ADDR:PORT.
    const auto endpoint = protocol::parse_endpoint(said);
    const auto named = endpoint ? address_of(endpoint->host) : std::nullopt;
    if (!named) {
      from.unread = said;
      break;
    }
    from.address = *named;
  }
  return from;
}

}  // namespace aucast::server
