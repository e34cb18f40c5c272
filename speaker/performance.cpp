#include "speaker/performance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "common/au_numbers.h"
#include "speaker/lips.h"

namespace aucast::speaker {
namespace {

/// What is kept of an expression while the lips speak: this share of kMouth, nothing of kLipsOnly.
constexpr float kMouthWhileSpeaking = 0.55F;
const std::set<int> kMouth{kUpperLipRaiser,     kLipCornerPuller,   kSharpLipPuller, kDimpler,
                           kLipCornerDepressor, kLowerLipDepressor, kChinRaiser,     kLipStretcher,
                           kLipTightener,       kLipPresser};
const std::set<int> kLipsOnly{kLipPucker, kTongueShow,   kLipFunneler, kLipsPart,
                              kJawDrop,   kMouthStretch, kLipsSuck,    kBite};

/// When the word that follows character `at` is heard; nullopt: none follows.
std::optional<Milliseconds> heard_at(const Speech& speech, std::size_t at) {
  for (const Word& word : speech.words) {
    if (word.at + word.length > at) return word.begin;
  }
  return std::nullopt;
}

void express(const std::vector<AuTerm>& terms, Milliseconds from, Milliseconds to, Curves& curves) {
  constexpr Milliseconds kOnset{350};
  constexpr Milliseconds kOffset{600};
  for (const AuTerm& term : terms) {
    if (term.number == 0 || kLipsOnly.contains(term.number)) continue;
    const float share = kMouth.contains(term.number) ? kMouthWhileSpeaking : 1.0F;
    const float intensity = share * static_cast<float>(term.percent) / 100;
    std::vector<float>& samples = curves.of(term.number, term.side);
    for (std::size_t i = curves.index(from - kOnset); i <= curves.index(to + kOffset); ++i) {
      const Milliseconds at = Curves::kStep * static_cast<int>(i);
      const auto part = [](Milliseconds a, Milliseconds b) {
        return static_cast<float>(a.count()) / static_cast<float>(b.count());
      };
      const float up = part(at - (from - kOnset), kOnset);
      const float down = part(to + kOffset - at, kOffset);
      samples[i] = std::max(samples[i], intensity * std::clamp(std::min(up, down), 0.0F, 1.0F));
    }
  }
}

void follow_cues(const Speech& speech, const Script& script, const Expressions& expressions,
                 Curves& curves) {
  for (std::size_t i = 0; i < script.cues.size(); ++i) {
    const Cue& cue = script.cues[i];
    const auto paragraph = std::upper_bound(script.ends.begin(), script.ends.end(), cue.at);
    std::size_t end = paragraph != script.ends.end() ? *paragraph : characters(script.text);
    if (i + 1 < script.cues.size()) end = std::min(end, script.cues[i + 1].at);
    const auto from = heard_at(speech, cue.at);
    const auto terms = terms_of(cue.name, expressions);
    if (from && terms)
      express(*terms, *from, heard_at(speech, end).value_or(speech.length()), curves);
  }
}

/// The curves at one step, as they are written.
std::vector<AuTerm> terms_at(const Curves& curves, std::size_t step) {
  constexpr int kPercentMin = 2;  // weaker is nothing
  std::vector<AuTerm> terms;
  int both = 0;  // of the AU in hand: its sides come after
  int both_of = 0;
  for (const auto& [key, samples] : curves.samples) {
    const auto [number, side] = key;
    const int percent = percent_of(samples[step]);
    if (number != both_of) both = 0;
    both_of = number;
    if (side == Side::Both) both = percent;
    if (percent < kPercentMin || (side != Side::Both && percent <= both)) continue;
    terms.push_back({static_cast<std::uint8_t>(number), side, static_cast<std::uint8_t>(percent)});
  }
  if (terms.empty()) terms.push_back({0, Side::Both, 100});
  return terms;
}

/// The step between two that lies farthest from the straight lines between them, if any does by
/// more than the tolerance.
std::optional<std::size_t> worst_between(const Curves& curves, std::size_t from, std::size_t to,
                                         float tolerance) {
  std::optional<std::size_t> worst;
  for (const auto& [key, samples] : curves.samples) {
    const float slope = (samples[to] - samples[from]) / static_cast<float>(to - from);
    for (std::size_t i = from + 1; i < to; ++i) {
      const float line = samples[from] + slope * static_cast<float>(i - from);
      if (const float off = std::abs(samples[i] - line); off > tolerance) {
        tolerance = off;
        worst = i;
      }
    }
  }
  return worst;
}

}  // namespace

protocol::StreamFile perform(const Speech& speech, const Script& script,
                             const Expressions& expressions, const GestureOptions& options) {
  constexpr float kTolerance = 0.07F;
  Curves curves(speech.length());
  add_gestures(speech, script, options, curves);
  follow_cues(speech, script, expressions, curves);
  move_lips(speech.phonemes, speech.length(), curves);
  return {keyframes_of(curves, kTolerance)};
}

std::vector<protocol::Keyframe> keyframes_of(const Curves& curves, float tolerance) {
  constexpr std::size_t kLongest = 50;  // steps: who joins waits no longer for a whole face
  std::vector<std::size_t> stops;
  for (std::size_t from = 0; from + 1 < curves.steps;) {
    // The farthest point splits a stretch until each is straight enough.
    std::vector<std::size_t> ends{std::min(from + kLongest, curves.steps - 1)};
    while (!ends.empty()) {
      if (const auto split = worst_between(curves, from, ends.back(), tolerance)) {
        ends.push_back(*split);
        continue;
      }
      from = ends.back();
      stops.push_back(from);
      ends.pop_back();
    }
  }
  std::vector<protocol::Keyframe> keyframes;
  std::size_t before = 0;
  for (const std::size_t stop : stops) {
    protocol::Keyframe keyframe;
    keyframe.terms = terms_at(curves, stop);
    keyframe.time_ms = static_cast<std::uint32_t>((stop - before) *
                                                  static_cast<std::size_t>(Curves::kStep.count()));
    keyframes.push_back(std::move(keyframe));
    before = stop;
  }
  return keyframes;
}

}  // namespace aucast::speaker
