#pragma once

#include <optional>
#include <string>
#include <vector>

#include <asio/ip/address.hpp>

#include "common/web/http.h"

namespace aucast::server {

/// Who may ask --web for what. Thread: none of its own.

/// Why a request is not answered at all: it is for another host. Nothing: it is.
[[nodiscard]] std::optional<web::HttpReply> refuse_host(const web::HttpRequest& request,
                                                        const std::vector<std::string>& names);

/// Why a request cannot become a WebSocket: what it asks for, or the page that asks. Nothing: it
/// can.
[[nodiscard]] std::optional<web::HttpReply> refuse_web_socket(
    const web::HttpRequest& request, const std::vector<std::string>& names);

/// Whom a request comes from: `peer`, or, if that is one of the trusted proxies, whom it names last
/// in X-Forwarded-For and is no such proxy itself.
[[nodiscard]] asio::ip::address asker(const web::HttpRequest& request,
                                      const asio::ip::address& peer,
                                      const std::vector<std::string>& trusted_proxies);

}  // namespace aucast::server
