#include "protocol/codec.h"

#include <algorithm>

#include "common/check.h"
#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

constexpr auto kFullEveryMs = static_cast<std::uint64_t>(kFullKeyframeEvery.count());

/// Stands for an AU and side that are not named.
constexpr std::uint8_t kUnnamed = 255;

AuPercents percents_of(const Keyframe& keyframe, std::uint8_t initial) {
  AuPercents percents;
  percents.left.fill(initial);
  percents.right.fill(initial);
  for (const AuTerm& term : keyframe.terms) {
    if (term.number == 0 || term.number > kAuNumberMax) continue;
    const std::uint8_t percent = std::min<std::uint8_t>(term.percent, 100);
    const bool of_right = term.side == Side::Both && shows_on_one_side(term.number);
    if (term.side != Side::Right && !of_right) percents.left[term.number] = percent;
    if (term.side != Side::Left) percents.right[term.number] = percent;
  }
  return percents;
}

void append_term(std::string& text, const char* side, std::size_t number, std::uint8_t percent) {
  if (percent == kUnnamed) return;
  if (text.size() > 1 && text.back() != '~') text += ',';
  text += side;
  text += std::to_string(number);
  if (percent != 100) text += ':' + std::to_string(percent);
}

/// "{1:30,R12:80": the terms of the AUs that are named.
std::string opened(const AuPercents& named, std::string_view brace) {
  std::string text(brace);
  for (std::size_t number = 1; number < kAuCount; ++number) {
    const std::uint8_t left = named.left[number];
    const std::uint8_t right = named.right[number];
    const bool joined = left == right && !shows_on_one_side(static_cast<int>(number));
    append_term(text, joined ? "" : "L", number, left);
    if (!joined) append_term(text, "R", number, right);
  }
  return text;
}

std::string closed(std::string text, const Keyframe& timing) {
  if (timing.time_ms) {
    text += ';' + std::to_string(*timing.time_ms);
    if (timing.place_ms) text += '@' + std::to_string(*timing.place_ms);
  }
  return text + '}';
}

std::string opened_full(AuPercents percents) {
  std::replace(percents.left.begin(), percents.left.end(), std::uint8_t{0}, kUnnamed);
  std::replace(percents.right.begin(), percents.right.end(), std::uint8_t{0}, kUnnamed);
  std::string text = opened(percents, "{");
  return text.size() > 1 ? text : "{0";
}

std::string opened_changes(const AuPercents& from, AuPercents to) {
  for (std::size_t number = 1; number < kAuCount; ++number) {
    std::uint8_t& left = to.left[number];
    std::uint8_t& right = to.right[number];
    const bool left_stays = left == from.left[number];
    const bool right_stays = right == from.right[number];
    // A side that stays may be named too: one term for both is shorter than one with its side.
    const bool joins = left == right && !shows_on_one_side(static_cast<int>(number));
    if (joins && left_stays != right_stays) continue;
    if (left_stays) left = kUnnamed;
    if (right_stays) right = kUnnamed;
  }
  return opened(to, "{~");
}

std::string classic_of(const AuPercents& percents, int percent_min) {
  std::string text = "{";
  for (std::size_t number = 1; number < kAuCount; ++number) {
    const int percent = std::max(percents.left[number], percents.right[number]);
    if (percent > 0 && percent >= percent_min) append_term(text, "", number, 100);
  }
  return text.append(text.size() > 1 ? "}" : "0}");
}

}  // namespace

std::string encode_classic(const Keyframe& keyframe, int percent_min) {
  return classic_of(percents_of(keyframe, 0), percent_min);
}

std::string encode(const Keyframe& keyframe) {
  return closed(keyframe.changes_only ? opened(percents_of(keyframe, kUnnamed), "{~")
                                      : opened_full(percents_of(keyframe, 0)),
                keyframe);
}

EncodedKeyframe KeyframeEncoder::next(const Keyframe& keyframe) {
  AUCAST_CHECK(!keyframe.changes_only);
  const AuPercents percents = percents_of(keyframe, 0);
  const std::uint64_t time_ms = keyframe.time_ms.value_or(keyframe_ms_);
  EncodedKeyframe encoded;
  encoded.classic = classic_of(percents, classic_min_);
  encoded.full = closed(opened_full(percents), keyframe);
  encoded.plain = encoded.full.find_first_of(":LR;") == std::string::npos;
  // Where the next keyframe would come too late for being the full one, this one is.
  const bool due = !last_ || since_full_ms_ + time_ms > kFullEveryMs;
  if (!due) encoded.changes = closed(opened_changes(*last_, percents), keyframe);
  if (due || encoded.changes.size() >= encoded.full.size()) {
    encoded.changes = encoded.full;
    since_full_ms_ = 0;
  }
  since_full_ms_ += time_ms;
  last_ = percents;
  return encoded;
}

std::string encode(const End&) {
  return "{-2}";
}

std::string encode(Code code) {
  return std::to_string(static_cast<int>(code));
}

std::string format_au_set(const AuFrame& frame) {
  const std::string packet = encode(Keyframe{canonical_terms(frame), false, {}, {}});
  return packet.substr(1, packet.size() - 2);
}

bool is_stream_name(std::string_view name) {
  const auto fits = [](char byte) {
    return (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
           (byte >= 'a' && byte <= 'z') || byte == '.' || byte == '_' || byte == '-';
  };
  return !name.empty() && name.size() <= kStreamNameBytesMax &&
         std::all_of(name.begin(), name.end(), fits);
}

}  // namespace aucast::protocol
