#pragma once

#include <optional>
#include <string>

#include "common/time.h"
#include "protocol/encoded_track.h"

namespace aucast::protocol {

/// Sends the voice to one client. Knows how far it was sent, and so which packet continues the last
/// one and which needs its place.
class VoiceCursor {
 public:
  /// Appends the packet to `out`: {a DATA} if it begins where the last one ended, else {a@PLACE
  /// DATA}. `shift`: added to a place on the packet's clock, gives the client's. False: the packet
  /// was left out, since it would begin before the end of the last one, or before 0 on the client's
  /// clock.
  bool send(const EncodedVoice& voice, Milliseconds shift, std::string& out);

 private:
  std::optional<Milliseconds> end_;  ///< of the last packet, on the client's clock
};

}  // namespace aucast::protocol
