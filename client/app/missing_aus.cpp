#include "client/app/missing_aus.h"

#include <algorithm>

#include "client/face/muscle_mixer.h"

namespace aucast::app {

std::string MissingAus::look_at(const pipeline::AuMapping& mapping, const AuFrame& aus) {
  AuFrame missing;
  bool any = false;
  for (std::size_t number = 1; number < kAuCount; ++number) {
    const float intensity = std::max(aus.left[number], aus.right[number]);
    if (intensity <= 0 || said_.test(number)) continue;
    if (mapping.recordings.contains(static_cast<int>(number))) continue;
    missing.left[number] = intensity;
    said_.set(number);
    any = true;
  }
  return any ? missing_text(mapping.face, missing) : std::string();
}

std::string missing_text(const face::Face& face, const AuFrame& aus) {
  const std::string missing = face::not_shown(face, aus);
  return missing.empty() ? missing : "the face '" + face.name + "' cannot show AU " + missing;
}

}  // namespace aucast::app
