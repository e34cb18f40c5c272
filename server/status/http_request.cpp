#include "server/status/http_request.h"

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>

#include <asio/ip/address.hpp>

#include "common/text_file.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

constexpr std::string_view kLineEnd = "\r\n";

std::string_view phrase(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 421:
      return "Misdirected Request";
    case 431:
      return "Request Header Fields Too Large";
    case 503:
      return "Service Unavailable";
    default:
      return "HTTP Version Not Supported";
  }
}

HttpProgress refused(int status, std::string why) {
  return {std::nullopt, HttpReply{status, HttpReply().type, std::move(why) + "\n"}};
}

bool is_token_char(char c) {
  const auto code = static_cast<unsigned char>(c);
  return std::isalnum(code) != 0 ||
         std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

bool is_token(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_token_char);
}

bool is_visible(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > 0x20 && c < 0x7f; });
}

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

/// Takes the next line, without its end; the head is known to be whole.
std::string_view take_line(std::string_view& head) {
  const std::size_t end = head.find(kLineEnd);
  const std::string_view line = head.substr(0, end);
  head.remove_prefix(end + kLineEnd.size());
  return line;
}

struct RequestLine {
  std::string_view method;
  std::string_view target;
  std::string_view version;
};

std::optional<RequestLine> split(std::string_view line) {
  const std::size_t first = line.find(' ');
  const std::size_t last = line.rfind(' ');
  if (first == std::string_view::npos || first == last) return std::nullopt;
  const RequestLine parts{line.substr(0, first), line.substr(first + 1, last - first - 1),
                          line.substr(last + 1)};
  const bool good = is_token(parts.method) && is_visible(parts.target) &&
                    parts.target.starts_with('/') && is_visible(parts.version);
  return good ? std::optional(parts) : std::nullopt;
}

struct Field {
  std::string name;  ///< in small letters
  std::string_view value;
};

/// A header field; nothing when the line is none.
std::optional<Field> field_of(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) return std::nullopt;
  const std::string_view value = line.substr(colon + 1);
  const bool clean = std::none_of(value.begin(), value.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 0x20 && c != '\t') || code == 0x7f;
  });
  if (!clean) return std::nullopt;
  return Field{lower(line.substr(0, colon)), trimmed(value, " \t")};
}

}  // namespace

HttpProgress read_http_request(std::string_view bytes) {
  const std::size_t end = bytes.substr(0, protocol::kHttpHeadBytesMax).find("\r\n\r\n");
  if (end == std::string_view::npos) {
    if (bytes.size() >= protocol::kHttpHeadBytesMax) return refused(431, "the request is too long");
    // Noise is refused as soon as its first byte shows it.
    if (!bytes.empty() && !is_token_char(bytes.front())) return refused(400, "no request");
    return {};
  }
  std::string_view head = bytes.substr(0, end + 2);
  const auto line = split(take_line(head));
  if (!line) return refused(400, "no request line");
  if (line->version != "HTTP/1.1" && line->version != "HTTP/1.0") {
    const bool http = line->version.starts_with("HTTP/");
    return refused(http ? 505 : 400, "only HTTP/1.0 and HTTP/1.1 are spoken here");
  }
  int hosts = 0;
  std::string host;
  while (!head.empty()) {
    const auto field = field_of(take_line(head));
    if (!field) return refused(400, "a header field is malformed");
    if (field->name == "host") {
      ++hosts;
      host = field->value;
    }
    if (field->name == "transfer-encoding" || field->name == "content-length") {
      return refused(400, "a request has no body here");
    }
  }
  if (hosts > 1 || (hosts == 0 && line->version == "HTTP/1.1")) {
    return refused(400, "one Host field is needed");
  }
  if (line->method != "GET" && line->method != "HEAD") {
    return refused(405, "only GET and HEAD are answered here");
  }
  const std::string_view path = line->target.substr(0, line->target.find('?'));
  return {HttpRequest{std::string(path), line->method == "HEAD", std::move(host)}, std::nullopt};
}

bool is_own_host(std::string_view host, std::string_view bound) {
  if (host.empty()) return true;
  const bool bracketed = host.starts_with('[') && host.find(']') != std::string_view::npos;
  std::string name =
      lower(bracketed ? host.substr(1, host.find(']') - 1) : host.substr(0, host.find(':')));
  if (name.ends_with('.')) name.pop_back();  // the root of all names
  std::error_code no_address;
  static_cast<void>(asio::ip::make_address(name, no_address));
  return !no_address || name == "localhost" || name == lower(bound);
}

std::string format_http_reply(const HttpReply& reply, bool head) {
  std::string text = "HTTP/1.1 " + std::to_string(reply.status) + " ";
  text += phrase(reply.status);
  text += "\r\nContent-Type: " + reply.type;
  text += "\r\nContent-Length: " + std::to_string(reply.body.size());
  if (reply.status == 405) text += "\r\nAllow: GET, HEAD";
  text += "\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff";
  text += "\r\nConnection: close\r\n\r\n";
  return head ? text : text + reply.body;
}

}  // namespace aucast::server
