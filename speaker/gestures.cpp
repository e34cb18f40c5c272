#include "speaker/gestures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "common/au_numbers.h"
#include "common/mixed_bits.h"

namespace aucast::speaker {
namespace {

using std::chrono::duration_cast;

/// Numbers in [0,1) from a seed: the same on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}
  [[nodiscard]] float roll() { return static_cast<float>(bits_.next() >> 40U) / 16777216.0F; }
  [[nodiscard]] float between(float low, float high) { return low + (high - low) * roll(); }
  [[nodiscard]] Milliseconds between(Milliseconds low, Milliseconds high) {
    return low + Milliseconds(static_cast<int>(static_cast<float>((high - low).count()) * roll()));
  }

 private:
  SplitMix64 bits_;
};

/// How far the inner ends of raised brows go, of the outer ends: as far, and the face pleads.
constexpr float kInnerShare = 0.45F;

/// Brows and head begin to move before the word that they stress is heard.
constexpr Milliseconds kBeforeWord{140};

/// A movement: rises, stays, falls.
struct Beat {
  Milliseconds begin;
  Milliseconds onset;
  Milliseconds apex;
  Milliseconds offset;
};

float eased(float x) {
  return 0.5F - 0.5F * std::cos(std::numbers::pi_v<float> * std::clamp(x, 0.0F, 1.0F));
}

float share(Milliseconds part, Milliseconds whole) {
  return whole.count() == 0 ? 1.0F
                            : static_cast<float>(part.count()) / static_cast<float>(whole.count());
}

void put(Curves& curves, int au, const Beat& beat, float intensity) {
  const Milliseconds end = beat.begin + beat.onset + beat.apex + beat.offset;
  std::vector<float>& samples = curves.of(au);
  for (std::size_t i = curves.index(beat.begin); i <= curves.index(end); ++i) {
    const Milliseconds at = Curves::kStep * static_cast<int>(i);
    const float up = share(at - beat.begin, beat.onset);
    const float down = share(end - at, beat.offset);
    samples[i] = std::max(samples[i], intensity * eased(std::min(up, down)));
  }
}

void raise_brows(Curves& curves, const Beat& beat, float intensity) {
  put(curves, kInnerBrowRaiser, beat, kInnerShare * intensity);
  put(curves, kOuterBrowRaiser, beat, intensity);
}

/// Pauses that separate phrases.
struct Pause {
  Milliseconds begin;
  Milliseconds end;
};

std::vector<Pause> pauses_of(const Speech& speech) {
  constexpr Milliseconds kPauseMin{220};
  std::vector<Pause> pauses;
  for (std::size_t i = 0; i < speech.phonemes.size(); ++i) {
    const Pause pause{speech.phonemes[i].begin, speech.phoneme_end(i)};
    const bool silent = speech.phonemes[i].ipa.empty();
    if (silent && pause.end - pause.begin >= kPauseMin) pauses.push_back(pause);
  }
  return pauses;
}

void blink(const Speech& speech, Dice& dice, Curves& curves) {
  constexpr Milliseconds kRareMax{4800};
  constexpr Milliseconds kApart{1600};
  std::vector<Milliseconds> moments;
  Milliseconds last{-2000};
  const auto add = [&](Milliseconds at) {
    if (at - last < kApart) return;
    moments.push_back(at);
    last = at;
  };
  std::size_t clause = 0;
  for (Milliseconds at = dice.between(Milliseconds(600), Milliseconds(2500)); at < speech.length();
       at += dice.between(Milliseconds(2200), kRareMax)) {
    for (; clause < speech.clause_ends.size() && speech.clause_ends[clause] < at; ++clause) {
      if (dice.roll() < 0.7F) add(speech.clause_ends[clause] + Milliseconds(60));
    }
    add(at);
  }
  for (const Milliseconds at : moments) {
    put(curves, kBlink, {at, Milliseconds(110), Milliseconds(30), Milliseconds(190)}, 1);
  }
}

void stress(const Speech& speech, const std::vector<bool>& stressed, const GestureOptions& options,
            Dice& dice, Curves& curves) {
  constexpr Milliseconds kApart{750};
  Milliseconds last{-10000};
  for (std::size_t i = 0; i < speech.words.size(); ++i) {
    const Milliseconds at = speech.words[i].begin;
    if (!stressed[i] || at - last < kApart) continue;
    last = at;
    const float brows = dice.between(0.4F, 0.8F) * options.amount;
    const float nod = dice.between(0.12F, 0.28F) * options.amount;
    const float what = dice.roll();
    if (what < 0.75F) {
      const Beat beat{at - kBeforeWord, Milliseconds(200),
                      dice.between(Milliseconds(60), Milliseconds(260)), Milliseconds(380)};
      raise_brows(curves, beat, brows);
      // Brows that rise over lids that stay are drawn on.
      put(curves, kUpperLidRaiser, beat, 0.35F * brows);
    } else {
      // Weight without raised brows: eyes and forehead gather a little.
      const Beat beat{at - kBeforeWord, Milliseconds(220), Milliseconds(200), Milliseconds(420)};
      put(curves, kBrowLowerer, beat, 0.4F * brows);
      put(curves, kLidTightener, beat, 0.6F * brows);
    }
    if (what > 0.3F) {
      put(curves, kHeadDown,
          {at - Milliseconds(90), Milliseconds(190), Milliseconds(30), Milliseconds(330)}, nod);
    }
  }
}

/// The mark that ends the sentence in which `word` stands.
char sentence_mark(const Characters& script, const Word& word) {
  const std::string_view rest = script.part(word.at, script.count());
  const std::size_t at = rest.find_first_of(".?!\n");
  return at == std::string_view::npos ? '.' : rest[at];
}

void end_clauses(const Speech& speech, const Script& script, const GestureOptions& options,
                 Dice& dice, Curves& curves) {
  const Characters characters_of_script(script.text);
  std::size_t next = 0;
  for (const Milliseconds end : speech.clause_ends) {
    while (next < speech.words.size() && speech.words[next].begin < end) ++next;
    if (next == 0) continue;
    const Word& last = speech.words[next - 1];
    if (sentence_mark(characters_of_script, last) == '?') {
      const Beat beat{last.begin - Milliseconds(150), Milliseconds(250), Milliseconds(450),
                      Milliseconds(500)};
      const float brows = dice.between(0.4F, 0.6F) * options.amount;
      raise_brows(curves, beat, brows);
      put(curves, kHeadUp, beat, 0.2F * options.amount);
    } else {
      put(curves, kHeadDown,
          {last.begin + Milliseconds(60), Milliseconds(260), Milliseconds(80), Milliseconds(600)},
          dice.between(0.14F, 0.28F) * options.amount);
    }
  }
}

/// Turns the head a little from one phrase to the next, and less on words within it. Its curves are
/// written once, from the beginning to the end.
class Drift {
 public:
  static constexpr Milliseconds kTurnTime{650};

  Drift(int plus, int minus, float reach) : plus_(plus), minus_(minus), reach_(reach) {}

  /// By `part` of the way to anywhere within its reach. Call it in the order of time.
  void move(Milliseconds at, float part, Dice& dice, Curves& curves) {
    const float next = value_ + part * (dice.between(-reach_, reach_) - value_);
    // A head that is still turning goes on.
    if (at < since_ + kTurnTime) return;
    write(curves.index(at), curves);
    before_ = value_;
    value_ = next;
    since_ = at;
  }

  /// After the last move.
  void finish(Curves& curves) { write(curves.steps, curves); }

 private:
  void write(std::size_t end, Curves& curves) {
    std::vector<float>& plus = curves.of(plus_);
    std::vector<float>& minus = curves.of(minus_);
    for (; written_ < end; ++written_) {
      const Milliseconds turned = Curves::kStep * static_cast<int>(written_) - since_;
      const float value = before_ + (value_ - before_) * eased(share(turned, kTurnTime));
      plus[written_] = std::max(0.0F, value);
      minus[written_] = std::max(0.0F, -value);
    }
  }

  int plus_;
  int minus_;
  float reach_;
  float before_ = 0;
  float value_ = 0;
  Milliseconds since_ = -kTurnTime;  ///< when it began to turn from `before_` to `value_`
  std::size_t written_ = 0;          ///< steps
};

void wander(const Speech& speech, const std::vector<bool>& stressed, const GestureOptions& options,
            Dice& dice, Curves& curves) {
  constexpr float kOnWords = 0.5F;
  Drift turn(kHeadLeft, kHeadRight, 0.24F * options.amount);
  Drift tilt(kHeadTiltLeft, kHeadTiltRight, 0.2F * options.amount);
  std::size_t word = 0;
  const auto move_on_words_until = [&](Milliseconds end) {
    for (; word < speech.words.size() && speech.words[word].begin < end; ++word) {
      // A turn on the last word would take the place of the one to the next phrase.
      if (!stressed[word] || speech.words[word].begin + Drift::kTurnTime > end) continue;
      turn.move(speech.words[word].begin - kBeforeWord, kOnWords, dice, curves);
      tilt.move(speech.words[word].begin, kOnWords, dice, curves);
    }
  };
  for (const Pause& pause : pauses_of(speech)) {
    move_on_words_until(pause.begin);
    turn.move(pause.begin, 1, dice, curves);
    tilt.move(pause.begin + Milliseconds(80), 1, dice, curves);
    const bool long_enough = pause.end - pause.begin > Milliseconds(350);
    if (long_enough && dice.roll() < 0.4F * options.amount) {
      const int side = dice.roll() < 0.5F ? kEyesLeft : kEyesRight;
      const Beat glance{pause.begin, Milliseconds(60), pause.end - pause.begin - Milliseconds(150),
                        Milliseconds(60)};
      put(curves, side, glance, dice.between(0.15F, 0.3F));
      put(curves, kEyesDown, glance, dice.between(0.04F, 0.16F));
    }
  }
  move_on_words_until(speech.length());
  turn.finish(curves);
  tilt.finish(curves);
}

/// The difference of two opposite AUs grows by `change`, step by step.
template <typename Change>
void add(Curves& curves, int plus, int minus, const Change& change) {
  std::vector<float>& to_plus = curves.of(plus);
  std::vector<float>& to_minus = curves.of(minus);
  for (std::size_t i = 0; i < curves.steps; ++i) {
    const float value = std::clamp(to_plus[i] - to_minus[i] + change(i), -1.0F, 1.0F);
    to_plus[i] = std::max(0.0F, value);
    to_minus[i] = std::max(0.0F, -value);
  }
}

/// Eyes go the other way by as much as the head turns and nods: who speaks looks at the listeners,
/// whatever the head does. Eyes that go with it look past them.
void look_at_listeners(Curves& curves) {
  // On the project's faces a turn is 35 degrees, a nod 22, and the eyes go 28 and 22.
  constexpr float kAsideByTurn = 35.0F / 28;
  constexpr float kUpByNod = 1;
  const std::vector<float>& left = curves.of(kHeadLeft);
  const std::vector<float>& right = curves.of(kHeadRight);
  add(curves, kEyesRight, kEyesLeft,
      [&](std::size_t i) { return kAsideByTurn * (left[i] - right[i]); });
  const std::vector<float>& down = curves.of(kHeadDown);
  const std::vector<float>& up = curves.of(kHeadUp);
  add(curves, kEyesUp, kEyesDown, [&](std::size_t i) { return kUpByNod * (down[i] - up[i]); });
}

/// A way to look at the listeners: AUs at their full share.
struct Bearing {
  int first_au;
  float first;
  int second_au;
  float second;
};

/// Between the beats of stressed words a speaker's face does not go blank: each phrase is said
/// openly, warmly or intently, until the next pause.
void bear(const Speech& speech, const GestureOptions& options, Dice& dice, Curves& curves) {
  constexpr std::array<Bearing, 3> kBearings{
      {{kInnerBrowRaiser, 0.48F * kInnerShare, kOuterBrowRaiser, 0.48F},
       {kCheekRaiser, 0.55F, kLipCornerPuller, 0.48F},
       {kBrowLowerer, 0.34F, kLidTightener, 0.42F}}};
  constexpr Milliseconds kOnset{450};
  constexpr Milliseconds kOffset{600};
  std::size_t which = 1;  // whoever begins to speak greets
  Milliseconds begin{0};
  const auto say_phrase = [&](Milliseconds end) {
    const Milliseconds apex = std::max(end - begin - kOnset, Milliseconds(0));
    const float share = dice.between(0.6F, 1.0F) * options.amount;
    const Beat beat{begin, kOnset, apex, kOffset};
    put(curves, kBearings[which].first_au, beat, share * kBearings[which].first);
    put(curves, kBearings[which].second_au, beat, share * kBearings[which].second);
    which = (which + (dice.roll() < 0.5F ? 1 : 2)) % kBearings.size();
    begin = end;
  };
  for (const Pause& pause : pauses_of(speech)) say_phrase(pause.begin);
  say_phrase(speech.length());
}

}  // namespace

std::vector<bool> stressed_words(const Speech& speech) {
  constexpr std::size_t kLettersMin = 4;
  constexpr std::size_t kNeighbours = 4;
  constexpr float kLouder = 1.1F;
  const auto sample_at = [&](Milliseconds time) {
    const auto at = static_cast<std::size_t>(time.count()) * static_cast<std::size_t>(speech.rate);
    return std::min(at / 1000, speech.samples.size());
  };
  std::vector<float> loudness;
  for (std::size_t i = 0; i < speech.words.size(); ++i) {
    float loudest = 0;
    for (std::size_t k = sample_at(speech.words[i].begin); k < sample_at(speech.word_begin(i + 1));
         ++k) {
      loudest = std::max(loudest, std::abs(speech.samples[k]));
    }
    loudness.push_back(loudest);
  }
  std::vector<bool> stressed(speech.words.size());
  for (std::size_t i = 0; i < loudness.size(); ++i) {
    const std::size_t from = i > kNeighbours ? i - kNeighbours : 0;
    const std::size_t to = std::min(i + kNeighbours + 1, loudness.size());
    float sum = 0;
    for (std::size_t k = from; k < to; ++k) sum += loudness[k];
    const float mean = sum / static_cast<float>(to - from);
    stressed[i] = speech.words[i].length >= kLettersMin && loudness[i] > kLouder * mean;
  }
  return stressed;
}

void add_gestures(const Speech& speech, const Script& script, const GestureOptions& options,
                  Curves& curves) {
  Dice dice(options.seed);
  const std::vector<bool> stressed = stressed_words(speech);
  wander(speech, stressed, options, dice, curves);
  stress(speech, stressed, options, dice, curves);
  end_clauses(speech, script, options, dice, curves);
  blink(speech, dice, curves);
  bear(speech, options, dice, curves);
  look_at_listeners(curves);
}

}  // namespace aucast::speaker
