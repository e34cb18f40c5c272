#pragma once

#include <optional>
#include <string>

#include "common/time.h"
#include "protocol/encoded_track.h"

namespace aucast::protocol {

/// Sends the voice to one client. Knows where the last packet ended, and so which packet continues
/// it and which needs its place.
class VoiceCursor {
 public:
  /// Appends the packet to `out`: {a DATA} if it begins where the last one ended, else {a@PLACE
  /// DATA}. `shift` is added to a place on the packet's clock to get the place on the client's
  /// clock. Returns false if the packet was left out because it would begin before the end of the
  /// last one, or before 0 on the client's clock.
  bool send(const EncodedVoice& voice, Milliseconds shift, std::string& out);

 private:
  std::optional<Milliseconds> end_;  ///< of the last packet, on the client's clock
};

}  // namespace aucast::protocol
