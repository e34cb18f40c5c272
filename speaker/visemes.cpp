#include "speaker/visemes.h"

#include <algorithm>
#include <utility>

#include "common/au_numbers.h"

namespace aucast::speaker {
namespace {

// AUs by class: tried on the project's own faces. Who leads and who dominates: Edwards et al., JALI
// (SIGGRAPH 2016): rounded and hushing sounds begin early and take over their neighbours.
constexpr Viseme kPause{"pause", {}, 0.6F, 0};
constexpr Viseme kClosed{"closed", {{{kLipPresser, 0.25F}}}, 1.0F, 60, true};
constexpr Viseme kTeeth{"teeth", {{{kBite, 0.85F}}}, 1.0F, 60, false, true};
constexpr Viseme kRound{"round", {{{kLipPucker, 0.8F}, {kLipFunneler, 0.8F}}}, 0.9F, 150};
constexpr Viseme kRoundOpen{
    "round open", {{{kLipFunneler, 0.75F}, {kLipsPart, 0.35F}, {kJawDrop, 0.45F}}}, 0.8F, 130};
constexpr Viseme kHush{
    "hush", {{{kLipFunneler, 0.7F}, {kLipsPart, 0.4F}, {kJawDrop, 0.05F}}}, 0.85F, 130};
constexpr Viseme kHiss{
    "hiss", {{{kLipStretcher, 0.2F}, {kLipsPart, 0.45F}, {kJawDrop, 0.05F}}}, 0.6F, 90};
constexpr Viseme kTongueTeeth{
    "tongue", {{{kTongueShow, 0.2F}, {kLipsPart, 0.45F}, {kJawDrop, 0.15F}}}, 0.6F, 80};
constexpr Viseme kWide{
    "wide", {{{kLipStretcher, 0.6F}, {kLipsPart, 0.5F}, {kJawDrop, 0.15F}}}, 0.7F, 100};
constexpr Viseme kMidFront{
    "mid front", {{{kLipStretcher, 0.25F}, {kLipsPart, 0.55F}, {kJawDrop, 0.5F}}}, 0.7F, 110};
constexpr Viseme kOpen{"open", {{{kLipsPart, 0.6F}, {kJawDrop, 0.66F}}}, 0.75F, 120};
constexpr Viseme kMid{"mid", {{{kLipsPart, 0.5F}, {kJawDrop, 0.4F}}}, 0.4F, 100};
constexpr Viseme kR{
    "r", {{{kLipFunneler, 0.25F}, {kLipsPart, 0.35F}, {kJawDrop, 0.15F}}}, 0.5F, 100};

constexpr std::pair<std::string_view, const Viseme*> kLetters[] = {
    {"tʃ", &kHush},     {"dʒ", &kHush},       {"tɕ", &kHush},       {"dʑ", &kHush},
    {"ts", &kHiss},     {"dz", &kHiss},       {"pf", &kClosed},     {"p", &kClosed},
    {"b", &kClosed},    {"m", &kClosed},      {"ɓ", &kClosed},      {"f", &kTeeth},
    {"v", &kTeeth},     {"ɱ", &kTeeth},       {"ʋ", &kTeeth},       {"ɸ", &kRound},
    {"β", &kRound},     {"θ", &kTongueTeeth}, {"ð", &kTongueTeeth}, {"s", &kHiss},
    {"z", &kHiss},      {"ʃ", &kHush},        {"ʒ", &kHush},        {"ɕ", &kHush},
    {"ʑ", &kHush},      {"ʂ", &kHush},        {"ʐ", &kHush},        {"w", &kRound},
    {"ʍ", &kRound},     {"ɥ", &kRound},       {"u", &kRound},       {"ʊ", &kRound},
    {"y", &kRound},     {"ʏ", &kRound},       {"ʉ", &kRound},       {"o", &kRoundOpen},
    {"ɔ", &kRoundOpen}, {"ɒ", &kRoundOpen},   {"ø", &kRoundOpen},   {"œ", &kRoundOpen},
    {"ɵ", &kRoundOpen}, {"ɞ", &kRoundOpen},   {"a", &kOpen},        {"ɑ", &kOpen},
    {"æ", &kOpen},      {"ɐ", &kOpen},        {"ʌ", &kOpen},        {"ɶ", &kOpen},
    {"e", &kMidFront},  {"ɛ", &kMidFront},    {"i", &kWide},        {"ɪ", &kWide},
    {"ɨ", &kWide},      {"j", &kWide},        {"ʎ", &kWide},        {"ə", &kMid},
    {"ɜ", &kMid},       {"ɚ", &kMid},         {"ɝ", &kMid},         {"ɘ", &kMid},
    {"ɤ", &kMid},       {"ɯ", &kMid},         {"ɹ", &kR},           {"ɻ", &kR},
    {"r", &kR},
};

constexpr std::string_view kVowels[] = {"a", "ɑ", "æ", "ɐ", "ʌ", "e", "ɛ", "i", "ɪ", "o",
                                        "ɔ", "ɒ", "u", "ʊ", "ə", "ɜ", "y", "ʏ", "ø", "œ"};

/// How many bytes the vowel at the beginning of `ipa` has; 0: there is none.
std::size_t vowel_bytes(std::string_view ipa) {
  for (const std::string_view vowel : kVowels) {
    if (ipa.starts_with(vowel)) return vowel.size();
  }
  return 0;
}

}  // namespace

const Viseme& pause_viseme() {
  return kPause;
}

const Viseme* viseme_of(std::string_view ipa) {
  if (ipa.empty()) return &kPause;
  for (const auto& [letters, viseme] : kLetters) {
    if (ipa.starts_with(letters)) return viseme;
  }
  return nullptr;
}

const Viseme* glide_of(std::string_view ipa) {
  const std::size_t first = vowel_bytes(ipa);
  if (first == 0 || vowel_bytes(ipa.substr(first)) == 0) return nullptr;
  return viseme_of(ipa.substr(first));
}

int closure_before_ms(std::string_view ipa) {
  constexpr int kVoicelessStop = 50;
  constexpr int kVoicedStop = 30;
  if (ipa.starts_with("p")) return kVoicelessStop;
  return ipa.starts_with("b") ? kVoicedStop : 0;
}

}  // namespace aucast::speaker
