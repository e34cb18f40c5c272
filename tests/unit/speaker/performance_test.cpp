#include "speaker/performance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "common/au_numbers.h"
#include "speaker/espeak_voice.h"
#include "speaker/gestures.h"
#include "tests/unit/speaker/performed.h"

namespace aucast::speaker {
namespace {

const char* const kText =
    "[smile] Peter Piper picked a peck of pickled peppers.\n\nMaybe Bob may mop the big map? "
    "[surprise 50] Perhaps.\n";

struct Spoken {
  Script script;
  Speech speech;
  protocol::StreamFile stream;
};

Spoken spoken() {
  const Expressions expressions{{"surprise", {{1, Side::Both, 100}, {2, Side::Both, 100}}}};
  auto script = parse_script(kText, "t");
  EXPECT_TRUE(script);
  auto speech = speak(script->text, {});
  EXPECT_TRUE(speech) << speech.error().message;
  auto stream = perform(*speech, *script, expressions, {});
  return {*script, *speech, stream};
}

/// The intensity of an AU at a moment, as a player that draws straight lines shows it.
float shown(const protocol::StreamFile& stream, int au, Milliseconds time) {
  const auto of = [au](const protocol::Keyframe& keyframe) {
    for (const AuTerm& term : keyframe.terms) {
      if (term.number == au) return static_cast<float>(term.percent) / 100;
    }
    return 0.0F;
  };
  float from = 0;
  Milliseconds begin{0};
  for (const protocol::Keyframe& keyframe : stream.keyframes) {
    const Milliseconds end = begin + Milliseconds(*keyframe.time_ms);
    if (time <= end) {
      const float mu =
          static_cast<float>((time - begin).count()) / static_cast<float>((end - begin).count());
      return from + (of(keyframe) - from) * mu;
    }
    from = of(keyframe);
    begin = end;
  }
  return from;
}

/// The quietest 10 ms in the 80 ms before a moment: where the lips are shut, by the sound alone.
Milliseconds quietest_before(const Speech& speech, Milliseconds burst) {
  Milliseconds best = burst;
  float least = 1e9F;
  const std::size_t window = static_cast<std::size_t>(speech.rate) / 100;
  for (Milliseconds at = burst - Milliseconds(80); at <= burst; at += Milliseconds(5)) {
    const std::size_t from = static_cast<std::size_t>(std::max<long>(at.count(), 0)) *
                             static_cast<std::size_t>(speech.rate) / 1000;
    float energy = 0;
    for (std::size_t i = from; i < from + window && i < speech.samples.size(); ++i) {
      energy += speech.samples[i] * speech.samples[i];
    }
    if (energy < least) {
      least = energy;
      best = at;
    }
  }
  return best + Milliseconds(5);
}

TEST(Perform, LipsAreShutWhereTheSoundSaysSo) {
  const Spoken talk = spoken();
  int stops = 0;
  for (const Phoneme& phoneme : talk.speech.phonemes) {
    if (!phoneme.ipa.starts_with("p")) continue;
    ++stops;
    const Milliseconds shut = quietest_before(talk.speech, phoneme.begin);
    float nearest = 1;
    for (Milliseconds at = shut - Milliseconds(25); at <= shut + Milliseconds(25);
         at += Milliseconds(5)) {
      nearest = std::min(nearest, shown(talk.stream, 25, at));
    }
    EXPECT_LT(nearest, 0.08F) << "the p at " << phoneme.begin.count() << " ms";
  }
  EXPECT_GE(stops, 9);
}

TEST(Perform, TheFaceLastsAsLongAsTheSound) {
  const Spoken talk = spoken();
  const auto length = static_cast<double>(media_ms(talk.stream, 250));
  EXPECT_NEAR(length, static_cast<double>(talk.speech.length().count()), 20);
}

TEST(Perform, TheSameSeedGivesTheSameFaceAndAnotherAnother) {
  const Spoken talk = spoken();
  const auto with_seed = [&talk](std::uint64_t seed) {
    return perform(talk.speech, talk.script, {}, {seed, 1}).keyframes;
  };
  EXPECT_TRUE(with_seed(1) == with_seed(1));
  EXPECT_FALSE(with_seed(1) == with_seed(2));
}

/// Sounds of `phrase` each, with pauses between them.
Speech phrases(Milliseconds phrase, int count) {
  constexpr Milliseconds kPause{300};
  Speech speech;
  Milliseconds at{0};
  for (int i = 0; i < count; ++i) {
    speech.phonemes.push_back({"a", at});
    speech.phonemes.push_back({"", at + phrase});
    at += phrase + kPause;
  }
  speech.samples.resize(static_cast<std::size_t>(at.count()) * 22050 / 1000);
  return speech;
}

/// How fast the head turns or tilts at most: the greatest change between two steps.
float fastest(const Curves& curves, int plus, int minus) {
  const std::vector<float>& to_plus = curves.samples.at({plus, Side::Both});
  const std::vector<float>& to_minus = curves.samples.at({minus, Side::Both});
  float most = 0;
  for (std::size_t i = 1; i < curves.steps; ++i) {
    const float before = to_plus[i - 1] - to_minus[i - 1];
    most = std::max(most, std::abs(to_plus[i] - to_minus[i] - before));
  }
  return most;
}

TEST(AddGestures, TheHeadNeverSnapsFromPhraseToPhrase) {
  // From one end of its reach to the other in 650 ms, eased.
  constexpr float kTurnMax = 0.48F * 1.571F * 20 / 650;
  constexpr float kTiltMax = 0.4F * 1.571F * 20 / 650;
  for (const int phrase_ms : {150, 500, 2000}) {
    const Speech speech = phrases(Milliseconds(phrase_ms), 40);
    Curves curves(speech.length());
    add_gestures(speech, {}, {}, curves);
    const float turn = fastest(curves, kHeadLeft, kHeadRight);
    EXPECT_GT(turn, 0.004F) << phrase_ms;
    EXPECT_LT(turn, kTurnMax) << phrase_ms;
    EXPECT_LT(fastest(curves, kHeadTiltLeft, kHeadTiltRight), kTiltMax) << phrase_ms;
  }
}

TEST(AddGestures, NoAuOfTheHeadOfAScriptSnaps) {
  const auto script = parse_script(
      "Good morning, and welcome. What you see is not a video. It is a face.\n\nWhy would one do "
      "that? Because some links are thin. A boat, a village, an island.\n\nThey have names. Six "
      "and twelve make a happy face. Brows up. Lips apart.\n",
      "t");
  ASSERT_TRUE(script);
  const auto speech = speak(script->text, {});
  ASSERT_TRUE(speech) << speech.error().message;
  Curves curves(speech->length());
  add_gestures(*speech, *script, {}, curves);
  // The quickest is a nod of 28 % in 190 ms, eased.
  constexpr float kNodMax = 0.28F * 1.571F * 20 / 190;
  for (const auto& [key, samples] : curves.samples) {
    if (key.first < kHeadLeft || key.first > kHeadTiltRight) continue;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      ASSERT_LT(std::abs(samples[i] - samples[i - 1]), kNodMax) << key.first << " at " << 20 * i;
    }
  }
}

TEST(Perform, CuesShowFromTheirWordToTheEndOfTheParagraph) {
  const Spoken talk = spoken();
  const auto first_end = talk.script.ends.front();
  Milliseconds second{0};
  for (const Word& word : talk.speech.words) {
    if (word.at >= first_end) {
      second = word.begin;
      break;
    }
  }
  EXPECT_GT(shown(talk.stream, 6, Milliseconds(1000)), 0.3F) << "[smile]";
  EXPECT_LT(shown(talk.stream, 6, second + Milliseconds(1000)), 0.05F);
  EXPECT_GT(shown(talk.stream, 2, talk.speech.length() - Milliseconds(600)), 0.3F);
}

TEST(Perform, AnExpressionOfOneSideStaysOnThatSide) {
  const Expressions expressions{{"contempt", {{12, Side::Right, 60}, {14, Side::Right, 80}}},
                                {"smile", {{12, Side::Both, 20}, {12, Side::Left, 90}}}};
  const auto script = parse_script("[contempt] Nobody told them so.\n\n[smile] Now we do.\n", "t");
  ASSERT_TRUE(script);
  const auto speech = speak(script->text, {});
  ASSERT_TRUE(speech) << speech.error().message;
  const protocol::StreamFile stream = perform(*speech, *script, expressions, {});
  int right = 0;
  int left = 0;
  for (const protocol::Keyframe& keyframe : stream.keyframes) {
    for (const AuTerm& term : keyframe.terms) {
      if (term.number == 14) {
        EXPECT_EQ(term.side, Side::Right);
        ++right;
      }
      if (term.number == 12 && term.side == Side::Left) left = std::max<int>(left, term.percent);
    }
  }
  EXPECT_GT(right, 0);
  EXPECT_NEAR(left, 50, 5) << "the file's own smile, as much as a speaking mouth leaves of it";
}

TEST(Perform, ACueOfOneSideInCapitalsIsShown) {
  const auto script = parse_script("[L12:80] Now we do.\n", "t");
  ASSERT_TRUE(script);
  const auto speech = speak(script->text, {});
  ASSERT_TRUE(speech) << speech.error().message;
  const protocol::StreamFile stream = perform(*speech, *script, {}, {});
  int left = 0;
  for (const protocol::Keyframe& keyframe : stream.keyframes) {
    for (const AuTerm& term : keyframe.terms) {
      if (term.number == 12 && term.side == Side::Left) left = std::max<int>(left, term.percent);
    }
  }
  EXPECT_GT(left, 40);
}

TEST(AddGestures, MoveTheUpperFaceOnTheFirstStressedWordByTheAmount) {
  const Spoken talk = spoken();
  const std::vector<bool> stressed = stressed_words(talk.speech);
  const auto first = std::find(stressed.begin(), stressed.end(), true);
  ASSERT_NE(first, stressed.end());
  const Milliseconds at =
      talk.speech.words[static_cast<std::size_t>(first - stressed.begin())].begin;
  const auto strongest = [&](std::initializer_list<int> aus, std::uint64_t seed, float amount) {
    Curves curves{talk.speech.length()};
    add_gestures(talk.speech, talk.script, {seed, amount}, curves);
    float most = 0;
    for (const int au : aus) {
      for (std::size_t i = curves.index(at); i <= curves.index(at + Milliseconds(200)); ++i) {
        most = std::max(most, curves.of(au)[i]);
      }
    }
    return most;
  };
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    EXPECT_GT(strongest({kOuterBrowRaiser, kLidTightener}, seed, 1), 0.1F) << "seed " << seed;
    EXPECT_EQ(strongest({kOuterBrowRaiser, kBrowLowerer, kLidTightener}, seed, 0), 0);
  }
}

TEST(AddGestures, NoPhraseIsSaidWithABlankFace) {
  const Spoken talk = spoken();
  Curves curves{talk.speech.length()};
  add_gestures(talk.speech, talk.script, {}, curves);
  for (const Word& word : talk.speech.words) {
    const std::size_t i = curves.index(word.begin + Milliseconds(300));
    float most = 0;
    for (const int au : {kOuterBrowRaiser, kLipCornerPuller, kLidTightener}) {
      most = std::max(most, curves.of(au)[i]);
    }
    EXPECT_GT(most, 0.05F) << word.begin.count() << " ms";
  }
}

TEST(KeyframesOf, StayWithinTheToleranceOfTheCurves) {
  Curves curves{Milliseconds(4000)};
  std::vector<float>& samples = curves.of(12);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = 0.5F - 0.5F * std::cos(static_cast<float>(i) / 9);
  }
  const protocol::StreamFile stream{keyframes_of(curves, 0.05F)};
  EXPECT_LT(stream.keyframes.size(), samples.size() / 2);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Milliseconds at = Curves::kStep * static_cast<int>(i);
    EXPECT_NEAR(shown(stream, 12, at), samples[i], 0.06F + 0.02F) << at.count() << " ms";
  }
}

TEST(Perform, GivesAStreamFileThatReadsBackWhateverTheAmount) {
  for (const float amount : {0.0F, 1.0F, 2.0F}) {
    const Performed face("[smirk] one [brows] two three? four\n\nfive. [L12:100,R12:20] six",
                         amount);
    protocol::StreamFile stream;
    stream.keyframes = face.keyframes();
    const auto read = protocol::parse_stream_file(protocol::format_stream_file(stream), "t");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->keyframes.size(), face.keyframes().size());
    std::uint64_t ms = 0;
    for (const protocol::Keyframe& keyframe : face.keyframes()) {
      ASSERT_TRUE(keyframe.time_ms);
      EXPECT_GT(*keyframe.time_ms, 0U);
      EXPECT_LE(*keyframe.time_ms, 1000U) << "who joins waits no longer for a whole face";
      ms += *keyframe.time_ms;
    }
    EXPECT_EQ(ms, static_cast<std::uint64_t>(face.length().count()) / 20 * 20);
  }
}

std::vector<AuTerm> last_terms(Curves curves) {
  return keyframes_of(curves, 0.01F).back().terms;
}

TEST(KeyframesOf, AFaceThatDoesNothingIsNeutral) {
  const Curves still(Milliseconds(500));
  const auto keyframes = keyframes_of(still, 0.01F);
  ASSERT_EQ(keyframes.size(), 1U);
  EXPECT_EQ(keyframes.front().terms, (std::vector<AuTerm>{{0, Side::Both, 100}}));
  EXPECT_EQ(keyframes.front().time_ms, 500U);
}

TEST(KeyframesOf, ASideIsNamedWhereItIsStrongerThanBoth) {
  Curves curves(Milliseconds(100));
  curves.of(12).back() = 0.5F;
  curves.of(12, Side::Left).back() = 0.8F;
  curves.of(12, Side::Right).back() = 0.4F;
  curves.of(14, Side::Right).back() = 0.3F;
  curves.of(26).back() = 0.014F;
  EXPECT_EQ(
      last_terms(curves),
      (std::vector<AuTerm>{{12, Side::Both, 50}, {12, Side::Left, 80}, {14, Side::Right, 30}}))
      << "a percent is nothing";
}

TEST(KeyframesOf, AJumpIsWhereItIsAndNotBefore) {
  Curves curves(Milliseconds(2000));
  std::vector<float>& samples = curves.of(45);
  std::fill(samples.begin() + 30, samples.begin() + 33, 1.0F);
  std::uint32_t at = 0;
  std::vector<std::uint32_t> shut;
  for (const protocol::Keyframe& keyframe : keyframes_of(curves, 0.07F)) {
    at += *keyframe.time_ms;
    if (keyframe.terms.front().number == 45) shut.push_back(at);
  }
  EXPECT_EQ(shut, (std::vector<std::uint32_t>{600, 640}));
  EXPECT_EQ(at, 2000U);
}

TEST(KeyframesOf, ASpeechShorterThanAStepHasNone) {
  EXPECT_TRUE(keyframes_of(Curves(Milliseconds(10)), 0.05F).empty());
}

TEST(CurvesIndex, StaysWithinTheCurve) {
  const Curves curves(Milliseconds(100));
  EXPECT_EQ(curves.steps, 6U);
  EXPECT_EQ(curves.index(Milliseconds(-300)), 0U);
  EXPECT_EQ(curves.index(Milliseconds(39)), 1U);
  EXPECT_EQ(curves.index(Milliseconds(100)), 5U);
  EXPECT_EQ(curves.index(Milliseconds(5000)), 5U);
}

}  // namespace
}  // namespace aucast::speaker
