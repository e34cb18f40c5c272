#include "common/web/http.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "common/text.h"
#include "common/text_file.h"

namespace aucast::web {
namespace {

constexpr std::string_view kLineEnd = "\r\n";

std::string_view phrase(int status) {
  switch (status) {
    case 101:
      return "Switching Protocols";
    case 200:
      return "OK";
    case 304:
      return "Not Modified";
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 421:
      return "Misdirected Request";
    case 426:
      return "Upgrade Required";
    case 431:
      return "Request Header Fields Too Large";
    case 503:
      return "Service Unavailable";
    case 505:
      return "HTTP Version Not Supported";
    default:
      return {};  // a phrase is optional (RFC 9112 4)
  }
}

HttpProgress refused(int status, std::string why) {
  return {std::nullopt, HttpReply{.status = status, .body = std::move(why) + "\n"}};
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

std::optional<RequestLine> request_line(std::string_view line) {
  const std::size_t first = line.find(' ');
  const std::size_t last = line.rfind(' ');
  if (first == std::string_view::npos || first == last) return std::nullopt;
  const RequestLine parts{line.substr(0, first), line.substr(first + 1, last - first - 1),
                          line.substr(last + 1)};
  const bool good = is_token(parts.method) && is_visible(parts.target) && is_visible(parts.version);
  return good ? std::optional(parts) : std::nullopt;
}

struct Field {
  std::string name;  ///< in small letters
  std::string_view value;
};

/// A header field; nullopt when the line is none.
std::optional<Field> field_of(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) return std::nullopt;
  const std::string_view value = line.substr(colon + 1);
  const bool clean = std::none_of(value.begin(), value.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 0x20 && c != '\t') || code == 0x7f;
  });
  if (!clean) return std::nullopt;
  return Field{lowered(line.substr(0, colon)), trimmed(value, " \t")};
}

/// What a request asks for: "/path", or "http://authority/path" (RFC 9112 3.2.2), whose authority
/// counts in place of the Host field. Whether it came over TLS is not known here.
struct Target {
  std::string_view authority;  ///< empty: the Host field has it
  std::string_view path;
};

std::optional<Target> target_of(std::string_view target) {
  if (target.starts_with('/')) return Target{{}, target};
  constexpr std::string_view kAfterScheme = "://";
  const std::size_t colon = std::min(target.find(kAfterScheme), target.size());
  const std::string scheme = lowered(target.substr(0, colon));
  if (scheme != "http" && scheme != "https") return std::nullopt;
  target.remove_prefix(colon);
  if (target.empty()) return std::nullopt;
  target.remove_prefix(kAfterScheme.size());
  const std::size_t slash = std::min(target.find('/'), target.size());
  if (slash == 0) return std::nullopt;
  return Target{target.substr(0, slash), slash == target.size() ? "/" : target.substr(slash)};
}

/// All fields of a head, whose request line was taken off; nullopt when one is malformed.
std::optional<std::map<std::string, std::string, std::less<>>> fields_of(std::string_view head) {
  std::map<std::string, std::string, std::less<>> fields;
  while (!head.empty()) {
    auto field = field_of(take_line(head));
    if (!field) return std::nullopt;
    const auto [place, is_first] = fields.try_emplace(std::move(field->name), field->value);
    if (!is_first) place->second += ", " + std::string(field->value);
  }
  return fields;
}

/// "gzip;q=0.5": the word alone, unless q says that it is not wanted.
std::string word_of(std::string_view part) {
  const std::vector<std::string_view> parts = split(part, ';');
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::string parameter = lowered(trimmed(parts[i], " \t"));
    const bool is_zero = parameter.find_first_not_of("0.", 2) == std::string::npos;
    if (parameter.starts_with("q=") && is_zero) return {};
  }
  return lowered(trimmed(parts.front(), " \t"));
}

}  // namespace

std::string_view HttpRequest::field(std::string_view name) const {
  const auto found = fields.find(name);
  return found == fields.end() ? std::string_view() : found->second;
}

bool has_word(std::string_view field, std::string_view word) {
  const std::string wanted = lowered(word);
  const std::vector<std::string_view> parts = split(field, ',');
  return std::any_of(parts.begin(), parts.end(),
                     [&wanted](std::string_view part) { return word_of(part) == wanted; });
}

namespace {

HttpProgress read_request(std::string_view bytes, std::size_t head_bytes_max) {
  const std::size_t end = bytes.substr(0, head_bytes_max).find("\r\n\r\n");
  if (end == std::string_view::npos) {
    if (bytes.size() >= head_bytes_max) return refused(431, "the request is too long");
    // Noise is refused as soon as its first byte shows it.
    if (!bytes.empty() && !is_token_char(bytes.front())) return refused(400, "no request");
    return {};
  }
  std::string_view head = bytes.substr(0, end + kLineEnd.size());
  const auto line = request_line(take_line(head));
  const auto target = line ? target_of(line->target) : std::nullopt;
  if (!target) return refused(400, "no request line");
  if (line->version != "HTTP/1.1" && line->version != "HTTP/1.0") {
    const bool http = line->version.starts_with("HTTP/");
    return refused(http ? 505 : 400, "only HTTP/1.0 and HTTP/1.1 are spoken here");
  }
  auto fields = fields_of(head);
  if (!fields) return refused(400, "a header field is malformed");
  const auto length = fields->find("content-length");
  const bool has_body =
      fields->contains("transfer-encoding") || (length != fields->end() && length->second != "0");
  if (has_body) return refused(400, "a request has no body here");
  const auto host = fields->find("host");
  const bool one_host = host == fields->end()
                            ? line->version == "HTTP/1.0"
                            : !host->second.empty() && host->second.find(',') == std::string::npos;
  if (!one_host) return refused(400, "one Host field is needed");
  if (!target->authority.empty()) fields->insert_or_assign("host", std::string(target->authority));
  if (line->method != "GET" && line->method != "HEAD") {
    return refused(405, "only GET and HEAD are answered here");
  }
  const std::string_view path = target->path.substr(0, target->path.find('?'));
  return {HttpRequest{std::string(path), line->method == "HEAD", line->version == "HTTP/1.1",
                      end + 2 * kLineEnd.size(), std::move(*fields)},
          std::nullopt};
}

}  // namespace

HttpProgress read_http_request(std::string_view bytes, std::size_t head_bytes_max) {
  HttpProgress progress = read_request(bytes, head_bytes_max);
  progress.head = bytes.starts_with("HEAD ");
  return progress;
}

std::string format_http_head(const HttpReply& reply, std::size_t body_bytes) {
  std::string text = "HTTP/1.1 " + std::to_string(reply.status) + " ";
  text += phrase(reply.status);
  if (!reply.type.empty()) {
    text += "\r\nContent-Type: " + reply.type;
    text += "\r\nContent-Length: " + std::to_string(body_bytes);
  }
  if (reply.status == 405) text += "\r\nAllow: GET, HEAD";
  text += "\r\nCache-Control: " + reply.cache + "\r\nX-Content-Type-Options: nosniff";
  for (const std::string& field : reply.fields) text += "\r\n" + field;
  return text + "\r\nConnection: close\r\n\r\n";
}

std::string format_http_reply(const HttpReply& reply, bool head) {
  const std::string text = format_http_head(reply, reply.body.size());
  return head ? text : text + reply.body;
}

}  // namespace aucast::web
