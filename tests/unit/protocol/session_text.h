#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "common/time.h"
#include "protocol/client_session.h"
#include "protocol/server_session.h"

namespace aucast::test {

/// Events as one line, in order: "send {1,6}", "shutdown", "close finished", joined by " | ".
[[nodiscard]] std::string text_of(const std::vector<protocol::ServerEvent>& events);
/// "lost", "protocol error", "refused", "silent".
[[nodiscard]] std::string_view name_of(protocol::SessionFailed::Why why);
/// "send 1", "store {1:30;40}", "granted window=4", "ended", "reconnect", "fail lost".
[[nodiscard]] std::string text_of(const std::vector<protocol::ClientEvent>& events);

/// The events that the session makes of all these bytes.
[[nodiscard]] std::vector<protocol::ClientEvent> read_all(protocol::ClientSession& session,
                                                          std::string_view bytes);

/// The reason of the close among the events; empty when there is none.
[[nodiscard]] std::string reason_of(const std::vector<protocol::ServerEvent>& events);
[[nodiscard]] std::string reason_of(const std::vector<protocol::ClientEvent>& events);

/// A stream of the given packets without times. A client of level 1 gets `classic` instead, unless
/// that is empty.
[[nodiscard]] protocol::EncodedStream encoded(std::initializer_list<std::string_view> negotiated,
                                              std::initializer_list<std::string_view> classic = {});

/// A stream of keyframes, with all its forms and times.
[[nodiscard]] protocol::EncodedStream encoded(const std::vector<protocol::Keyframe>& keyframes,
                                              int classic_min);

/// A recorded stream by its name.
[[nodiscard]] protocol::ServedStream served(std::string name, protocol::EncodedStream stream);

}  // namespace aucast::test
