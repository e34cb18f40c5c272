#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aucast::web {

/// Whether a Host field, "NAME[:PORT]", may mean this server. It does if it is an IP address,
/// localhost, one of `names` ("*.example.org" is any name with one more label), or empty. This
/// stops DNS rebinding: a foreign page that makes its name resolve to this server arrives with its
/// own name in Host.
[[nodiscard]] bool is_own_host(std::string_view host, const std::vector<std::string>& names);

/// Whether a page of this origin, "SCHEME://NAME[:PORT]", may talk to the server that it reaches as
/// `host`. It may if the origin is the same host, the browser's own computer, or one of `names`.
/// Browsers name the origin truthfully; other programs send no origin, so an empty one is accepted.
[[nodiscard]] bool is_own_origin(std::string_view origin, std::string_view host,
                                 const std::vector<std::string>& names);

/// Only the host of "NAME[:PORT]": in small letters, without port, brackets and final dot.
[[nodiscard]] std::string host_of(std::string_view host_and_port);

}  // namespace aucast::web
