#pragma once

#include <optional>
#include <string>
#include <vector>

#include <asio/ip/address.hpp>

#include "common/web/http.h"

/// Decides who may ask --web for what. Thread: none of its own.
namespace aucast::server {

/// The refusal of a request that is for another host; nullopt: it may be answered.
[[nodiscard]] std::optional<web::HttpReply> refuse_host(const web::HttpRequest& request,
                                                        const std::vector<std::string>& names);

/// The refusal of a request that cannot become a WebSocket, because it is invalid or because of the
/// page that it comes from; nullopt: it can.
[[nodiscard]] std::optional<web::HttpReply> refuse_web_socket(
    const web::HttpRequest& request, const std::vector<std::string>& names);

/// From where a request comes.
struct Asker {
  asio::ip::address address;
  std::string unread;  ///< what a trusted proxy says of it and is no address; empty: nothing
};

/// The asker is `peer` or, if that is a trusted proxy, the last address in X-Forwarded-For that is
/// not a trusted proxy. An address there may have a port, or brackets.
[[nodiscard]] Asker asker(const web::HttpRequest& request, const asio::ip::address& peer,
                          const std::vector<std::string>& trusted_proxies);

}  // namespace aucast::server
