#pragma once

#include <optional>
#include <string>

#include "common/time.h"
#include "protocol/encoded_track.h"

namespace aucast::protocol {

/// How far the voice has been sent to one client: knows which packet continues the last one and
/// which needs its place.
class VoiceCursor {
 public:
  /// Appends the packet to `out`: {a DATA} if it begins where the last one ended, else {a@PLACE
  /// DATA}. `shift`: from the packet's clock to the client's. One that would begin before the end
  /// of the last one, or of the client's clock, is left out: false.
  bool send(const EncodedVoice& voice, Milliseconds shift, std::string& out);

 private:
  std::optional<Milliseconds> end_;  ///< of the last one, on the client's clock
};

}  // namespace aucast::protocol
