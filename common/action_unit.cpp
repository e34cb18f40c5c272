#include "common/action_unit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace aucast {
namespace {

constexpr std::pair<int, std::string_view> kFacsNames[] = {
    {0, "Neutral Face"},
    {1, "Inner Brow Raiser"},
    {2, "Outer Brow Raiser"},
    {4, "Brow Lowerer"},
    {5, "Upper Lid Raiser"},
    {6, "Cheek Raiser"},
    {7, "Lid Tightener"},
    {8, "Lips Toward Each Other"},
    {9, "Nose Wrinkler"},
    {10, "Upper Lip Raiser"},
    {11, "Nasolabial Furrow Deepener"},
    {12, "Lip Corner Puller"},
    {13, "Sharp Lip Puller"},
    {14, "Dimpler"},
    {15, "Lip Corner Depressor"},
    {16, "Lower Lip Depressor"},
    {17, "Chin Raiser"},
    {18, "Lip Pucker"},
    {19, "Tongue Show"},
    {20, "Lip Stretcher"},
    {21, "Neck Tightener"},
    {22, "Lip Funneler"},
    {23, "Lip Tightener"},
    {24, "Lip Presser"},
    {25, "Lips Part"},
    {26, "Jaw Drop"},
    {27, "Mouth Stretch"},
    {28, "Lips Suck"},
    {29, "Jaw Thrust"},
    {30, "Jaw Sideways"},
    {31, "Jaw Clencher"},
    {32, "Bite"},
    {33, "Blow"},
    {34, "Puff"},
    {35, "Cheek Suck"},
    {36, "Tongue Bulge"},
    {37, "Lip Wipe"},
    {38, "Nostril Dilator"},
    {39, "Nostril Compressor"},
    {40, "Sniff"},
    {41, "Lid Droop"},
    {42, "Slit"},
    {43, "Eye Closure"},
    {44, "Squint"},
    {45, "Blink"},
    {46, "Wink"},
    {50, "Speech"},
    {51, "Head Turn Left"},
    {52, "Head Turn Right"},
    {53, "Head Up"},
    {54, "Head Down"},
    {55, "Head Tilt Left"},
    {56, "Head Tilt Right"},
    {57, "Head Forward"},
    {58, "Head Back"},
    {61, "Eyes Turn Left"},
    {62, "Eyes Turn Right"},
    {63, "Eyes Up"},
    {64, "Eyes Down"},
    {65, "Walleye"},
    {66, "Cross-eye"},
    {80, "Swallow"},
    {81, "Chewing"},
    {82, "Shoulder Shrug"},
    {84, "Head Shake Back and Forth"},
    {85, "Head Nod Up and Down"},
};

/// Names that FACS (1978), the thesis and the recognisers have for some of them.
constexpr std::pair<int, std::string_view> kOtherNames[] = {
    {11, "Nasolabial Deepener"},
    {11, "Nasolabial Fold Deepener"},
    {13, "Cheek Puffer"},
    {18, "Lip Puckerer"},
    {19, "Tongue Out"},
    {21, "Neck Tightner"},
    {22, "Lip Funneller"},
    {24, "Lip Pressor"},
    {28, "Lip Suck"},
    {32, "Lip Bite"},
    {33, "Cheek Blow"},
    {34, "Cheek Puff"},
    {43, "Eyes Closed"},
    {51, "Turn Left"},
    {52, "Turn Right"},
    {55, "Tilt Left"},
    {56, "Tilt Right"},
    {61, "Eyes Left"},
    {62, "Eyes Right"},
};

/// Small letters alone: "Cross-eye" and "cross eye" are the same name.
std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if (c >= 'a' && c <= 'z') letters += c;
  }
  return letters;
}

constexpr std::string_view kLeft = "left_";
constexpr std::string_view kRight = "right_";

}  // namespace

std::uint8_t percent_of(float intensity) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(intensity, 0.0F, 1.0F) * 100.0F));
}

std::string sided_name(Side side, std::string_view base) {
  if (side == Side::Both) return std::string(base);
  return std::string(side == Side::Left ? kLeft : kRight) + std::string(base);
}

SidedName split_side(std::string_view name) {
  if (name.starts_with(kLeft)) return {Side::Left, name.substr(kLeft.size())};
  if (name.starts_with(kRight)) return {Side::Right, name.substr(kRight.size())};
  return {Side::Both, name};
}

bool shows_on_one_side(int number) {
  constexpr int kJawSideways = 30;
  constexpr int kTongueBulge = 36;
  constexpr int kWink = 46;
  return number == kJawSideways || number == kTongueBulge || number == kWink;
}

void set_intensity(AuFrame& frame, std::uint8_t number, Side side, float intensity) {
  if (side == Side::Both && shows_on_one_side(number)) side = Side::Right;
  if (side != Side::Right) frame.left[number] = intensity;
  if (side != Side::Left) frame.right[number] = intensity;
}

void apply_terms(AuFrame& frame, std::span<const AuTerm> terms) {
  for (const AuTerm& term : terms) {
    if (term.number == 0 || term.number > kAuNumberMax) continue;
    const float intensity = static_cast<float>(term.percent) / 100.0F;
    set_intensity(frame, term.number, term.side, intensity);
  }
}

AuFrame between(const AuFrame& from, const AuFrame& to, double share) {
  const auto part = static_cast<float>(share);
  AuFrame frame;
  for (std::size_t number = 0; number < kAuCount; ++number) {
    frame.left[number] = std::lerp(from.left[number], to.left[number], part);
    frame.right[number] = std::lerp(from.right[number], to.right[number], part);
  }
  return frame;
}

AuFrame stronger(const AuFrame& a, const AuFrame& b) {
  AuFrame frame;
  for (std::size_t number = 0; number < kAuCount; ++number) {
    frame.left[number] = std::max(a.left[number], b.left[number]);
    frame.right[number] = std::max(a.right[number], b.right[number]);
  }
  return frame;
}

AuFrame frame_from_terms(std::span<const AuTerm> terms) {
  AuFrame frame;
  apply_terms(frame, terms);
  return frame;
}

std::vector<AuTerm> canonical_terms(const AuFrame& frame) {
  std::vector<AuTerm> terms;
  for (int number = 1; number <= kAuNumberMax; ++number) {
    const auto index = static_cast<std::size_t>(number);
    const auto id = static_cast<std::uint8_t>(number);
    const std::uint8_t left = percent_of(frame.left[index]);
    const std::uint8_t right = percent_of(frame.right[index]);
    if (left == right && !shows_on_one_side(number)) {
      if (left != 0) terms.push_back({id, Side::Both, left});
      continue;
    }
    if (left != 0) terms.push_back({id, Side::Left, left});
    if (right != 0) terms.push_back({id, Side::Right, right});
  }
  if (terms.empty()) terms.push_back({0, Side::Both, 100});
  return terms;
}

std::optional<std::string_view> facs_name(int number) {
  const auto* found = std::find_if(std::begin(kFacsNames), std::end(kFacsNames),
                                   [number](const auto& entry) { return entry.first == number; });
  if (found == std::end(kFacsNames)) return std::nullopt;
  return found->second;
}

std::optional<std::uint8_t> facs_number(std::string_view name) {
  const std::string letters = letters_of(name);
  for (const std::span<const std::pair<int, std::string_view>> names :
       {std::span<const std::pair<int, std::string_view>>(kFacsNames),
        std::span<const std::pair<int, std::string_view>>(kOtherNames)}) {
    for (const auto& [number, known] : names) {
      if (!letters.empty() && letters == letters_of(known)) {
        return static_cast<std::uint8_t>(number);
      }
    }
  }
  return std::nullopt;
}

std::optional<std::uint8_t> percent_of_letter(char letter) {
  switch (letter) {
    case 'A':
      return std::uint8_t{10};
    case 'B':
      return std::uint8_t{25};
    case 'C':
      return std::uint8_t{50};
    case 'D':
      return std::uint8_t{80};
    case 'E':
      return std::uint8_t{100};
    case 'x':
      return std::uint8_t{25};
    case 'y':
      return std::uint8_t{60};
    case 'z':
      return std::uint8_t{100};
    default:
      return std::nullopt;
  }
}

}  // namespace aucast
