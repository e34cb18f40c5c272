#include "client/gui/model/remote_settings.h"

#include <string_view>

#include "client/gui/texts/texts.h"

namespace aucast::gui {
namespace {

constexpr std::size_t kAddressMax = 253;

std::optional<std::string> outside(TextKey what, int value, int low, int high) {
  if (value >= low && value <= high) return std::nullopt;
  return tr("address.outside", tr(what), low, high);
}

std::optional<std::string> problem_of_host(const std::string& host, int port) {
  if (host.empty()) return tr("address.missing");
  if (host.size() > kAddressMax) return tr("address.too_long");
  for (const char c : host) {
    if (c <= ' ' || c > '~') return tr("address.letters");
  }
  return outside("address.port", port, 1, RemoteSettings::kPortMax);
}

std::string host_text(const std::string& host, int port) {
  const bool v6 = host.find(':') != std::string::npos;
  const std::string text = v6 ? "[" + host + "]" : host;
  return port == protocol::kDefaultPort ? text : text + ":" + std::to_string(port);
}

}  // namespace

std::optional<std::string> problem(const RemoteSettings& settings) {
  if (auto wrong = problem_of_host(settings.address, settings.port)) return wrong;
  for (const protocol::Endpoint& other : settings.others) {
    if (auto wrong = problem_of_host(other.host, other.port)) return wrong;
  }
  if (auto wrong = outside("address.buffer", settings.buffer, 1, RemoteSettings::kSetsMax))
    return wrong;
  if (auto wrong = outside("address.playout", settings.playout, 1, RemoteSettings::kSetsMax))
    return wrong;
  if (settings.playout > settings.buffer) {
    return tr("address.playout_larger");
  }
  if (auto wrong = outside("address.threshold", settings.threshold_percent, 1, 100)) return wrong;
  if (auto wrong = outside("address.behind", settings.behind_ms, 0, RemoteSettings::kBehindMsMax))
    return wrong;
  return outside("address.speed", settings.speed_ms, 0, RemoteSettings::kSpeedMsMax);
}

std::string address_text(const RemoteSettings& settings) {
  std::string text = host_text(settings.address, settings.port);
  for (const protocol::Endpoint& other : settings.others) {
    text += "," + host_text(other.host, other.port);
  }
  if (settings.stream.empty() && !settings.tls && settings.others.empty()) return text;
  text = (settings.tls ? "aucasts://" : "aucast://") + text;
  return settings.stream.empty() ? text : text + "/" + settings.stream;
}

std::string server_text(const RemoteSettings& settings) {
  RemoteSettings server = settings;
  server.stream.clear();
  return address_text(server);
}

RemoteSettings with_server_of(RemoteSettings settings, const RemoteSettings& other) {
  settings.address = other.address;
  settings.port = other.port;
  settings.others = other.others;
  settings.stream = other.stream;
  settings.tls = other.tls;
  settings.authorities_file = other.authorities_file;
  settings.token_file = other.token_file;
  return settings;
}

std::optional<std::string> take_address(std::string_view text, RemoteSettings& settings) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  if (text.empty()) return tr("address.missing");
  std::string whole(text);
  if (!protocol::is_stream_address(text)) whole.insert(0, "aucast://");
  const auto address = protocol::parse_stream_address(whole);
  if (!address) {
    if (protocol::is_stream_address(text)) return address.error().message;
    return tr("address.no_address");
  }
  settings.address = address->hosts.front().host;
  settings.port = address->hosts.front().port;
  settings.others.assign(address->hosts.begin() + 1, address->hosts.end());
  settings.stream = address->stream;
  settings.tls = address->tls;
  return std::nullopt;
}

}  // namespace aucast::gui
