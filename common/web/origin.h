#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aucast::web {

/// Whether a Host field, "NAME[:PORT]", is for this server: an IP address, localhost or one of its
/// names, of which "*.example.org" stands for one more label; or nothing. A page of another name
/// that leads its reader's browser here (DNS rebinding) names itself.
[[nodiscard]] bool is_own_host(std::string_view host, const std::vector<std::string>& names);

/// Whether a page of this origin, "SCHEME://NAME[:PORT]", may talk to the server that it reaches as
/// `host`: one of the same host, of the reader's own computer, or of one of the server's names.
/// Browsers name the origin truthfully; other programs send none, which is no reason to refuse.
[[nodiscard]] bool is_own_origin(std::string_view origin, std::string_view host,
                                 const std::vector<std::string>& names);

/// The host alone of "NAME[:PORT]": in small letters, without port, brackets and final dot.
[[nodiscard]] std::string host_of(std::string_view host_and_port);

}  // namespace aucast::web
