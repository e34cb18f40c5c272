#pragma once

#include <optional>
#include <string>
#include <vector>

#include <asio/ip/address.hpp>

#include "common/web/http.h"

namespace aucast::server {

/// Who may ask --web for what. Thread: none of its own.

/// Why a request is not answered at all: it is for another host. nullopt: it is answered.
[[nodiscard]] std::optional<web::HttpReply> refuse_host(const web::HttpRequest& request,
                                                        const std::vector<std::string>& names);

/// Why a request cannot become a WebSocket: because of what it asks for, or of the page that asks.
/// nullopt: it can.
[[nodiscard]] std::optional<web::HttpReply> refuse_web_socket(
    const web::HttpRequest& request, const std::vector<std::string>& names);

/// Whom a request comes from: `peer` or, if that is a trusted proxy, the last address in
/// X-Forwarded-For that is not a trusted proxy.
[[nodiscard]] asio::ip::address asker(const web::HttpRequest& request,
                                      const asio::ip::address& peer,
                                      const std::vector<std::string>& trusted_proxies);

}  // namespace aucast::server
