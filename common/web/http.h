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
  std::vector<std::string> fields{};  ///< more lines of the head, such as "Vary: Origin"
};

/// What a request that is whole asks for.
struct HttpRequest {
  std::string path;            ///< as it was written, without the query
  bool head = false;           ///< HEAD: everything but the body
  bool version_1_1 = false;    ///< else HTTP/1.0
  std::size_t head_bytes = 0;  ///< of what was read; what follows them is no part of the request
  std::map<std::string, std::string, std::less<>> fields{};  ///< names in small letters

  /// The value of a field, empty when there is none. Several of one name are joined by commas.
  [[nodiscard]] std::string_view field(std::string_view name) const;
};

/// What has been read of a request so far.
struct HttpProgress {
  std::optional<HttpRequest> request;  ///< it is whole
  std::optional<HttpReply> refusal;    ///< it will never be one that is answered otherwise
};

/// Reads the head of an HTTP/1.0 or 1.1 request, GET or HEAD without a body, of at most
/// `head_bytes_max`. Strict: lines end in CRLF, nothing is folded, and what is not understood is
/// refused. Neither member is set while the head is not complete.
[[nodiscard]] HttpProgress read_http_request(std::string_view bytes, std::size_t head_bytes_max);

/// Whether a comma-separated field has `word`, in any case and without parameters; a word with
/// q=0 is none.
[[nodiscard]] bool has_word(std::string_view field, std::string_view word);

/// The head of a reply as it goes out, for a body of so many bytes. The connection is closed after
/// the body.
[[nodiscard]] std::string format_http_head(const HttpReply& reply, std::size_t body_bytes);

/// The whole reply as it goes out; `head`: without its body.
[[nodiscard]] std::string format_http_reply(const HttpReply& reply, bool head);

}  // namespace aucast::web
