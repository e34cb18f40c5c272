#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace aucast::server {

struct HttpReply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
};

/// What a request that is whole asks for.
struct HttpRequest {
  std::string path;   ///< as it was written, without the query
  bool head = false;  ///< HEAD: everything but the body
  std::string host;   ///< the Host field as it was written; empty: HTTP/1.0 without one
};

/// What has been read of a request so far.
struct HttpProgress {
  std::optional<HttpRequest> request;  ///< it is whole
  std::optional<HttpReply> refusal;    ///< it will never be one that is answered otherwise
};

/// Reads the head of an HTTP/1.0 or 1.1 request, GET or HEAD without a body. Strict: lines end in
/// CRLF, nothing is folded, and what is not understood is refused. Neither member is set while the
/// head is not complete.
[[nodiscard]] HttpProgress read_http_request(std::string_view bytes);

/// Whether a request for `host` is for this server: an IP address, localhost or `bound`, each with
/// or without a port; or nothing. A page of another name that leads its reader's browser here (DNS
/// rebinding) names itself.
[[nodiscard]] bool is_own_host(std::string_view host, std::string_view bound);

/// The whole reply as it goes out. The connection is closed after it.
[[nodiscard]] std::string format_http_reply(const HttpReply& reply, bool head);

}  // namespace aucast::server
