#include "protocol/voice_cursor.h"

#include <string_view>

namespace aucast::protocol {

bool VoiceCursor::send(const EncodedVoice& voice, Milliseconds shift, std::string& out) {
  const Milliseconds begin = voice.begin + shift;
  if (begin < end_.value_or(Milliseconds{0})) return false;
  constexpr std::string_view kOpening = "{a";
  std::string_view rest = voice.continued;
  rest.remove_prefix(kOpening.size());
  out += kOpening;
  if (begin != end_) out.append("@").append(std::to_string(begin.count()));
  out += rest;
  end_ = voice.end + shift;
  return true;
}

}  // namespace aucast::protocol
