#include "protocol/changes.h"

#include <cstddef>

#include "common/check.h"
#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::protocol {

Keyframe changes_between(const Keyframe& from, const Keyframe& to) {
  AUCAST_CHECK(!from.changes_only && !to.changes_only);
  const AuFrame before = frame_from_terms(from.terms);
  const AuFrame after = frame_from_terms(to.terms);
  Keyframe changes;
  changes.changes_only = true;
  changes.duration_ms = to.duration_ms;
  changes.place_ms = to.place_ms;
  for (std::size_t number = 1; number < kAuCount; ++number) {
    const auto id = static_cast<std::uint8_t>(number);
    const std::uint8_t left = percent_of(after.left[number]);
    const std::uint8_t right = percent_of(after.right[number]);
    const bool left_changed = left != percent_of(before.left[number]);
    const bool right_changed = right != percent_of(before.right[number]);
    // A side that stays may be named too: one term for both is shorter than one with its side.
    const bool joined = left == right && !shows_on_one_side(static_cast<int>(number));
    if ((left_changed || right_changed) && joined) {
      changes.terms.push_back({id, Side::Both, left});
    } else {
      if (left_changed) changes.terms.push_back({id, Side::Left, left});
      if (right_changed) changes.terms.push_back({id, Side::Right, right});
    }
  }
  return changes;
}

std::string ChangesEncoder::next(const Keyframe& keyframe) {
  if (last_) since_full_ms_ += last_->duration_ms.value_or(keyframe_ms_);
  const std::uint64_t until_next_ms = since_full_ms_ + keyframe.duration_ms.value_or(keyframe_ms_);
  std::string full = encode(keyframe);
  // Where the next keyframe would come too late for being the full one, this one is.
  const bool due = !last_ || until_next_ms > static_cast<std::uint64_t>(kFullKeyframeEvery.count());
  std::string changes = due ? full : encode(changes_between(*last_, keyframe));
  last_ = keyframe;
  if (changes.size() < full.size()) return changes;
  since_full_ms_ = 0;
  return full;
}

std::vector<std::string> encode_changes(std::span<const Keyframe> keyframes,
                                        std::uint32_t keyframe_ms) {
  ChangesEncoder encoder(keyframe_ms);
  std::vector<std::string> packets;
  packets.reserve(keyframes.size());
  for (const Keyframe& keyframe : keyframes) packets.push_back(encoder.next(keyframe));
  return packets;
}

}  // namespace aucast::protocol
