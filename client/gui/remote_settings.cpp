#include "client/gui/remote_settings.h"

#include <charconv>
#include <string_view>
#include <system_error>

namespace aucast::gui {
namespace {

constexpr int kPortMax = 65535;
constexpr int kPortUsual = 4650;
constexpr int kSetsMax = 10'000;
constexpr int kSpeedMax = 1000;
constexpr std::size_t kAddressMax = 253;

std::optional<std::string> outside(std::string_view what, int value, int low, int high) {
  if (value >= low && value <= high) return std::nullopt;
  return std::string(what) + " must be " + std::to_string(low) + " to " + std::to_string(high);
}

}  // namespace

std::optional<std::string> problem(const RemoteSettings& settings) {
  if (settings.address.empty()) return "enter the address of an au-transmitter";
  if (settings.address.size() > kAddressMax) return "this address is too long";
  for (const char c : settings.address) {
    if (c <= ' ' || c > '~') return "an address has no blanks and only plain letters";
  }
  if (auto wrong = outside("the port", settings.port, 1, kPortMax)) return wrong;
  if (auto wrong = outside("the buffer", settings.buffer, 1, kSetsMax)) return wrong;
  if (auto wrong = outside("the playout buffer", settings.playout, 1, kSetsMax)) return wrong;
  if (settings.playout > settings.buffer) {
    return "the playout buffer must not be larger than the buffer";
  }
  if (auto wrong = outside("the threshold", settings.threshold_percent, 1, 100)) return wrong;
  return outside("the speed", settings.speed_ms, 0, kSpeedMax);
}

std::string endpoint_text(const RemoteSettings& settings) {
  const bool v6 = settings.address.find(':') != std::string::npos;
  const std::string host = v6 ? "[" + settings.address + "]" : settings.address;
  return settings.port == kPortUsual ? host : host + ":" + std::to_string(settings.port);
}

bool take_endpoint(std::string_view text, RemoteSettings& settings) {
  std::string_view host = text;
  std::string_view port;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) return false;
    host = text.substr(1, end - 1);
    const std::string_view rest = text.substr(end + 1);
    if (!rest.empty() && (rest.front() != ':' || rest.size() == 1)) return false;
    port = rest.empty() ? rest : rest.substr(1);
  } else if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (port.empty()) return false;
  }
  int number = kPortUsual;
  if (!port.empty()) {
    const char* const end = port.data() + port.size();
    const auto read = std::from_chars(port.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end) return false;
  }
  if (host.empty()) return false;
  settings.address = std::string(host);
  settings.port = number;
  return true;
}

}  // namespace aucast::gui
