#include "protocol/codec.h"

#include <algorithm>
#include <array>
#include <optional>

#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

void append_term(std::string& text, const AuTerm& term) {
  if (!text.empty()) text += ',';
  if (term.side == Side::Left) text += 'L';
  if (term.side == Side::Right) text += 'R';
  text += std::to_string(term.number);
  if (term.percent != 100) text += ':' + std::to_string(term.percent);
}

/// What a changes-only keyframe says of one AU; nothing for a side that it does not name.
struct Change {
  std::optional<std::uint8_t> left;
  std::optional<std::uint8_t> right;
};

/// Unlike a full keyframe, zeros stay: 6:0 says that AU 6 is gone.
std::vector<AuTerm> canonical_changes(const std::vector<AuTerm>& terms) {
  std::array<Change, kAuCount> changes{};
  for (const AuTerm& term : terms) {
    if (term.number == 0 || term.number > kAuNumberMax) continue;
    const bool of_right = term.side == Side::Both && shows_on_one_side(term.number);
    if (term.side != Side::Right && !of_right) changes[term.number].left = term.percent;
    if (term.side != Side::Left) changes[term.number].right = term.percent;
  }
  std::vector<AuTerm> canonical;
  for (std::size_t number = 1; number < changes.size(); ++number) {
    const auto& [left, right] = changes[number];
    const auto id = static_cast<std::uint8_t>(number);
    if (left && left == right && !shows_on_one_side(id)) {
      canonical.push_back({id, Side::Both, *left});
      continue;
    }
    if (left) canonical.push_back({id, Side::Left, *left});
    if (right) canonical.push_back({id, Side::Right, *right});
  }
  return canonical;
}

std::string joined(const std::vector<AuTerm>& terms) {
  std::string text;
  for (const AuTerm& term : terms) append_term(text, term);
  return text;
}

}  // namespace

std::string encode_classic(const Keyframe& keyframe, int percent_min) {
  const AuFrame frame = frame_from_terms(keyframe.terms);
  const float least = static_cast<float>(percent_min) / 100.0F;
  std::string text;
  for (std::size_t number = 1; number < kAuCount; ++number) {
    const float intensity = std::max(frame.left[number], frame.right[number]);
    if (intensity <= 0.0F || intensity < least) continue;
    append_term(text, {static_cast<std::uint8_t>(number), Side::Both, 100});
  }
  return '{' + (text.empty() ? "0" : text) + '}';
}

std::string encode(const Keyframe& keyframe) {
  std::string text = "{";
  if (keyframe.changes_only) {
    text += '~' + joined(canonical_changes(keyframe.terms));
  } else {
    text += joined(canonical_terms(frame_from_terms(keyframe.terms)));
  }
  if (keyframe.duration_ms) {
    text += ';' + std::to_string(*keyframe.duration_ms);
    if (keyframe.place_ms) text += '@' + std::to_string(*keyframe.place_ms);
  }
  return text + '}';
}

std::string encode(const End&) {
  return "{-2}";
}

std::string encode(Code code) {
  return std::to_string(static_cast<int>(code));
}

std::string format_au_set(const AuFrame& frame) {
  return joined(canonical_terms(frame));
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
