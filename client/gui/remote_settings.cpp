#include "client/gui/remote_settings.h"

#include <string_view>

namespace aucast::gui {
namespace {

constexpr int kPortMax = 65535;
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

}  // namespace aucast::gui
