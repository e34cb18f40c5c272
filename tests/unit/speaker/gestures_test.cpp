#include "speaker/gestures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "common/au_numbers.h"

namespace aucast::speaker {
namespace {

/// A minute of sound without a pause.
Speech minute() {
  Speech speech;
  speech.samples.assign(std::size_t{60} * 22050, 0.1F);
  speech.phonemes.push_back({"a", Milliseconds(0)});
  return speech;
}

float strongest(Curves& curves, int au, Milliseconds from, Milliseconds to) {
  const std::vector<float>& samples = curves.of(au);
  float most = 0;
  for (std::size_t i = curves.index(from); i <= curves.index(to); ++i) {
    most = std::max(most, samples[i]);
  }
  return most;
}

/// When the eyes are shut, in steps.
std::vector<std::size_t> blinks(Curves& curves) {
  const std::vector<float>& lids = curves.of(kBlink);
  std::vector<std::size_t> moments;
  for (std::size_t i = 1; i < lids.size(); ++i) {
    if (lids[i] > 0.9F && lids[i - 1] <= 0.9F) moments.push_back(i);
  }
  return moments;
}

TEST(StressedWords, AreLongEnoughAndLouderThanTheirNeighbours) {
  Speech speech = minute();
  for (std::size_t i = 0; i < 5; ++i) {
    speech.words.push_back({Milliseconds(1000 * static_cast<int>(i)), 5 * i, 4});
  }
  const auto louder = [&speech](std::size_t word) {
    std::fill_n(speech.samples.begin() + static_cast<std::ptrdiff_t>(word * 22050 + 5000), 1000,
                0.3F);
  };
  louder(1);
  louder(3);
  speech.words[3].length = 3;
  EXPECT_EQ(stressed_words(speech), (std::vector<bool>{false, true, false, false, false}));
}

TEST(AddGestures, TheEyesBlinkEveryFewSecondsWhateverTheAmount) {
  const Speech speech = minute();
  Curves curves(speech.length());
  add_gestures(speech, {}, {1, 0}, curves);
  const auto moments = blinks(curves);
  EXPECT_GE(moments.size(), 12U);
  for (std::size_t i = 1; i < moments.size(); ++i) {
    const auto apart = static_cast<int>(moments[i] - moments[i - 1]) * Curves::kStep;
    EXPECT_GE(apart, Milliseconds(1600));
    EXPECT_LE(apart, Milliseconds(6400));
  }
}

TEST(AddGestures, MostClausesEndWithABlink) {
  Speech speech = minute();
  for (int s = 5; s < 60; s += 5) speech.clause_ends.emplace_back(1000 * s);
  int with_blink = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Curves curves(speech.length());
    add_gestures(speech, {}, {seed, 1}, curves);
    for (const Milliseconds end : speech.clause_ends) {
      if (strongest(curves, kBlink, end + Milliseconds(150), end + Milliseconds(230)) > 0.9F) {
        ++with_blink;
      }
    }
  }
  EXPECT_GT(with_blink, 45) << "of 110; by chance some 10";
}

TEST(AddGestures, AQuestionEndsWithRaisedBrowsAndHead) {
  Speech speech = minute();
  speech.words = {{Milliseconds(1000), 0, 3}, {Milliseconds(10'000), 5, 3}};
  speech.clause_ends = {Milliseconds(1500), Milliseconds(10'500)};
  Script script;
  script.text = "Why? Now.\n\n";
  Curves curves(speech.length());
  add_gestures(speech, script, {}, curves);
  const auto during = [&](int au, int begin_ms) {
    return strongest(curves, au, Milliseconds(begin_ms), Milliseconds(begin_ms + 600));
  };
  EXPECT_GT(during(kOuterBrowRaiser, 1000), 0.35F);
  EXPECT_GT(during(kHeadUp, 1000), 0.15F);
  EXPECT_EQ(during(kHeadUp, 10'000), 0);
  EXPECT_GT(during(kHeadDown, 10'000), 0.1F);
}

TEST(StressedWords, ThereAreNoneWithoutWordsOrSound) {
  EXPECT_TRUE(stressed_words(minute()).empty());
  Speech silent;
  silent.words = {{Milliseconds(0), 0, 6}, {Milliseconds(900), 7, 6}};
  EXPECT_EQ(stressed_words(silent), (std::vector<bool>{false, false})) << "no samples at all";
}

/// A minute of words and phrases, as a lecture has them.
Speech lecture() {
  Speech speech = minute();
  speech.phonemes.clear();
  for (int s = 0; s < 60; s += 3) {
    speech.phonemes.push_back({"a", Milliseconds(1000 * s)});
    speech.phonemes.push_back({"", Milliseconds(1000 * s + 2400)});
    for (int w = 0; w < 4; ++w) {
      speech.words.push_back({Milliseconds(1000 * s + 600 * w), speech.words.size() * 6, 5});
    }
    speech.clause_ends.emplace_back(1000 * s + 2400);
    std::fill_n(speech.samples.begin() + 22050 * s + 15'000, 1000, 0.4F);
  }
  return speech;
}

TEST(AddGestures, LeaveTheMouthToItsSoundsButForASmile) {
  const Speech speech = lecture();
  Curves curves(speech.length());
  add_gestures(speech, {}, {1, 2}, curves);
  for (const auto& [key, samples] : curves.samples) {
    const bool below_the_eyes = key.first >= 9 && key.first < kHeadLeft && key.first != kBlink;
    EXPECT_FALSE(below_the_eyes && key.first != kLipCornerPuller) << "AU " << key.first;
    for (const float sample : samples) ASSERT_GE(sample, 0) << "AU " << key.first;
  }
}

TEST(AddGestures, NeverTurnTheHeadBothWaysAtOnce) {
  const Speech speech = lecture();
  Curves curves(speech.length());
  add_gestures(speech, {}, {}, curves);
  for (const auto& [plus, minus] :
       {std::pair{kHeadLeft, kHeadRight}, std::pair{kHeadTiltLeft, kHeadTiltRight}}) {
    for (std::size_t i = 0; i < curves.steps; ++i) {
      EXPECT_EQ(std::min(curves.of(plus)[i], curves.of(minus)[i]), 0) << 20 * i << " ms";
    }
  }
}

TEST(AddGestures, WithoutAnAmountTheFaceOnlyBlinks) {
  const Speech speech = lecture();
  Curves curves(speech.length());
  add_gestures(speech, {}, {1, 0}, curves);
  for (const auto& [key, samples] : curves.samples) {
    if (key.first == kBlink) continue;
    EXPECT_EQ(*std::max_element(samples.begin(), samples.end()), 0) << "AU " << key.first;
  }
}

TEST(AddGestures, TheEyesGoAsideFromTheListenersOnlyInAPause) {
  Speech speech = minute();
  speech.phonemes.clear();
  for (int s = 0; s < 60; s += 3) {
    speech.phonemes.push_back({"a", Milliseconds(1000 * s)});
    speech.phonemes.push_back({"", Milliseconds(1000 * s + 2000)});
  }
  Curves curves(speech.length());
  add_gestures(speech, {}, {}, curves);
  // Of the eyes on the head that they sit in: a whole turn of the head is 35 degrees, of the
  // eyes 28.
  const auto aside = [&curves](Milliseconds from, Milliseconds to) {
    float most = 0;
    for (std::size_t i = curves.index(from); i <= curves.index(to); ++i) {
      const float eyes = curves.of(kEyesLeft)[i] - curves.of(kEyesRight)[i];
      const float head = curves.of(kHeadLeft)[i] - curves.of(kHeadRight)[i];
      most = std::max(most, std::abs(28 * eyes + 35 * head) / 28);
    }
    return most;
  };
  float in_pauses = 0;
  for (int s = 0; s < 60; s += 3) {
    const Milliseconds begin(1000 * s);
    const Milliseconds pause = begin + Milliseconds(2000);
    EXPECT_LT(aside(begin, pause - Milliseconds(20)), 0.001F) << s;
    in_pauses = std::max(in_pauses, aside(pause, begin + Milliseconds(2980)));
  }
  EXPECT_GT(in_pauses, 0.14F);
  EXPECT_GT(strongest(curves, kHeadLeft, Milliseconds(0), speech.length()), 0.1F);
}

TEST(AddGestures, TheEyesStayOnTheListenersInANod) {
  Speech speech = minute();
  speech.words.push_back({Milliseconds(9500), 0, 4});
  speech.clause_ends.emplace_back(10'000);
  Curves curves(speech.length());
  add_gestures(speech, {}, {}, curves);
  const std::size_t nod = curves.index(Milliseconds(9860));
  EXPECT_GT(curves.of(kHeadDown)[nod], 0.1F);
  EXPECT_FLOAT_EQ(curves.of(kEyesUp)[nod], curves.of(kHeadDown)[nod]);
}

TEST(AddGestures, TheHeadMovesOnStressedWordsToo) {
  Speech speech = minute();
  for (int s = 0; s < 60; ++s) {
    speech.words.push_back({Milliseconds(1000 * s), static_cast<std::size_t>(5 * s), 4});
    if (s % 3 != 1) continue;
    std::fill_n(speech.samples.begin() + s * 22050 + 5000, 1000, 0.3F);
  }
  Curves curves(speech.length());
  add_gestures(speech, {}, {}, curves);
  EXPECT_GT(strongest(curves, kHeadLeft, Milliseconds(0), speech.length()), 0.05F);
  EXPECT_GT(strongest(curves, kHeadRight, Milliseconds(0), speech.length()), 0.05F);
}

}  // namespace
}  // namespace aucast::speaker
