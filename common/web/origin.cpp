#include "common/web/origin.h"

#include <algorithm>

#include "common/numeric_address.h"
#include "common/own_computer.h"
#include "common/text.h"

namespace aucast::web {
namespace {

bool matches(std::string_view host, const std::string& name) {
  const std::string wanted = host_of(name);
  if (!wanted.starts_with("*.")) return host == wanted;
  const std::size_t dot = host.find('.');
  return dot != 0 && dot != std::string_view::npos &&
         host.substr(dot) == std::string_view(wanted).substr(1);
}

bool is_one_of(const std::string& host, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&host](const std::string& name) { return matches(host, name); });
}

}  // namespace

std::string host_of(std::string_view host_and_port) {
  const std::size_t bracket = host_and_port.find(']');
  const bool bracketed = host_and_port.starts_with('[') && bracket != std::string_view::npos;
  std::string host(bracketed ? host_and_port.substr(1, bracket - 1)
                             : host_and_port.substr(0, host_and_port.find(':')));
  if (host.ends_with('.')) host.pop_back();  // the root of all names
  return lowered(host);
}

bool is_own_host(std::string_view host, const std::vector<std::string>& names) {
  if (host.empty()) return true;
  const std::string name = host_of(host);
  return name == "localhost" || !numeric_address(name).empty() || is_one_of(name, names);
}

bool is_own_origin(std::string_view origin, std::string_view host,
                   const std::vector<std::string>& names) {
  if (origin.empty()) return true;
  const std::size_t scheme = origin.find("://");
  if (scheme == std::string_view::npos) return false;
  const std::string name = host_of(origin.substr(scheme + 3));
  return !name.empty() &&
         (name == host_of(host) || is_own_computer(name) || is_one_of(name, names));
}

}  // namespace aucast::web
