#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aucast::web {

struct HttpReply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";  ///< empty: there is no body
  std::string body{};
  std::string cache = "no-store";     ///< Cache-Control
  std::vector<std::string> fields{};  ///< further header lines, such as "Vary: Origin"
};

/// A request that was read whole.
struct HttpRequest {
  std::string path;            ///< as it was written, without the query
  bool head = false;           ///< it is a HEAD request
  bool version_1_1 = false;    ///< else HTTP/1.0
  std::size_t head_bytes = 0;  ///< length of the request; bytes beyond are no part of it
  std::map<std::string, std::string, std::less<>> fields{};  ///< names in small letters

  /// The value of a field; empty when there is none. The values of several fields of one name are
  /// joined by commas.
  [[nodiscard]] std::string_view field(std::string_view name) const;
};

/// The result of reading a request, which may still be incomplete.
struct HttpProgress {
  std::optional<HttpRequest> request;  ///< set once it is whole
  std::optional<HttpReply> refusal;    ///< set once the request must be refused
  bool head = false;                   ///< the bytes begin a HEAD request: no reply gets a body
};

/// Reads the head of an HTTP/1.0 or 1.1 request of at most `head_bytes_max` bytes: GET or HEAD,
/// without a body. Strict: lines end in CRLF, nothing is folded, and what is not understood is
/// refused. Neither member is set while the head is incomplete.
[[nodiscard]] HttpProgress read_http_request(std::string_view bytes, std::size_t head_bytes_max);

/// Whether a comma-separated field has `word`. Case and parameters do not matter, except that a
/// word with q=0 does not count.
[[nodiscard]] bool has_word(std::string_view field, std::string_view word);

/// The bytes of a reply's head, for a body of `body_bytes`. The head says that the connection is
/// closed after the body.
[[nodiscard]] std::string format_http_head(const HttpReply& reply, std::size_t body_bytes);

/// The bytes of the whole reply; with `head`, for a HEAD request, without the body.
[[nodiscard]] std::string format_http_reply(const HttpReply& reply, bool head);

}  // namespace aucast::web
