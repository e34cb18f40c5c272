#include "speaker/lips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "speaker/visemes.h"

namespace aucast::speaker {
namespace {

float at(Curves& curves, int au, int ms) {
  return curves.of(au)[curves.index(Milliseconds(ms))];
}

Curves lips_of(const std::vector<Phoneme>& phonemes, int end_ms) {
  Curves curves{Milliseconds(end_ms)};
  move_lips(phonemes, Milliseconds(end_ms), curves);
  return curves;
}

TEST(Lips, MeetBeforeTheBurstOfAStopWhateverTheNeighboursWant) {
  Curves curves = lips_of({{"a", Milliseconds(100)},
                           {"p", Milliseconds(300)},
                           {"a", Milliseconds(340)},
                           {"", Milliseconds(600)}},
                          1000);
  for (const int ms : {260, 280, 300}) {
    EXPECT_EQ(at(curves, 25, ms), 0) << ms;
    EXPECT_FLOAT_EQ(at(curves, 24, ms), viseme_of("p")->aus[0].intensity) << ms;
    EXPECT_LT(at(curves, 26, ms), 0.2F) << ms;
  }
  EXPECT_GT(at(curves, 26, 180), 0.6F) << "open before";
  EXPECT_GT(at(curves, 26, 420), 0.6F) << "and after";
}

TEST(Lips, MeetBeforeABToo) {
  Curves curves =
      lips_of({{"a", Milliseconds(100)}, {"b", Milliseconds(300)}, {"a", Milliseconds(360)}}, 600);
  for (const int ms : {280, 300}) EXPECT_EQ(at(curves, 25, ms), 0) << ms;
}

TEST(Lips, StayTogetherWhileAnMIsHummedALittleAfterItsMark) {
  Curves curves =
      lips_of({{"ɔ", Milliseconds(100)}, {"m", Milliseconds(300)}, {"i", Milliseconds(400)}}, 700);
  for (int ms = 340; ms <= 400; ms += 20) EXPECT_EQ(at(curves, 25, ms), 0) << ms;
}

TEST(Lips, TouchTheTeethForAnF) {
  Curves curves =
      lips_of({{"a", Milliseconds(100)}, {"f", Milliseconds(300)}, {"a", Milliseconds(400)}}, 700);
  EXPECT_FLOAT_EQ(at(curves, 32, 340), viseme_of("f")->aus[0].intensity) << "as firm as it is";
  EXPECT_LT(at(curves, 26, 340), 0.25F);
}

TEST(Lips, AreRoundedBeforeTheRoundSoundIsHeard) {
  Curves curves = lips_of({{"t", Milliseconds(200)}, {"u", Milliseconds(300)}}, 700);
  EXPECT_GT(at(curves, 18, 260), 0.3F);
}

TEST(Lips, RestInAPause) {
  Curves curves =
      lips_of({{"a", Milliseconds(100)}, {"", Milliseconds(300)}, {"a", Milliseconds(1300)}}, 1600);
  EXPECT_LT(at(curves, 25, 800), 0.05F);
  EXPECT_LT(at(curves, 26, 800), 0.05F);
}

TEST(Lips, GoFromOneVowelToTheOtherInADiphthong) {
  Curves curves = lips_of({{"aɪ", Milliseconds(100)}, {"", Milliseconds(500)}}, 900);
  EXPECT_GT(at(curves, 26, 180), at(curves, 26, 440));
  EXPECT_GT(at(curves, 20, 440), at(curves, 20, 180));
}

TEST(Lips, StayWithinBoundsHoweverFastTheSoundsCome) {
  for (const int ms : {5, 20, 60, 200}) {
    std::vector<Phoneme> phonemes;
    int at_ms = 0;
    for (int round = 0; round < 10; ++round) {
      for (const char* ipa : {"p", "u", "f", "aɪ", "m", "", "ʃ", "iː", "t", "b", "əʊ"}) {
        phonemes.push_back({ipa, Milliseconds(at_ms)});
        at_ms += ms;
      }
    }
    const Curves curves = lips_of(phonemes, at_ms + 500);
    for (const auto& [key, samples] : curves.samples) {
      EXPECT_EQ(key.second, Side::Both);
      for (const float sample : samples) {
        ASSERT_TRUE(sample >= 0 && sample <= 1) << key.first << " at " << ms << " ms a sound";
      }
    }
  }
}

TEST(Lips, MoveForAnMSoundBetweenVowelsWithoutASnap) {
  const Curves curves =
      lips_of({{"a", Milliseconds(100)}, {"m", Milliseconds(300)}, {"a", Milliseconds(400)}}, 800);
  for (const auto& [key, samples] : curves.samples) {
    for (std::size_t i = 1; i < samples.size(); ++i) {
      // A contact is made in 50 ms and released in 40, of samples 20 ms apart.
      EXPECT_LT(std::abs(samples[i] - samples[i - 1]), 0.51F) << key.first << " at " << 20 * i;
    }
  }
}

TEST(Lips, KeepAStrongerIntensityThatIsThere) {
  Curves curves{Milliseconds(600)};
  std::fill(curves.of(26).begin(), curves.of(26).end(), 0.9F);
  move_lips({{"p", Milliseconds(200)}, {"a", Milliseconds(300)}}, Milliseconds(600), curves);
  for (const float sample : curves.of(26)) EXPECT_GE(sample, 0.9F);
}

TEST(Lips, ComeToRestOnlyInAPauseThatIsLongEnough) {
  const auto open_after = [](int pause_ms) {
    Curves curves = lips_of(
        {{"a", Milliseconds(100)}, {"", Milliseconds(300)}, {"a", Milliseconds(300 + pause_ms)}},
        450 + pause_ms);
    return at(curves, 26, 300 + pause_ms / 2);
  };
  EXPECT_GT(open_after(60), 0.5F);
  EXPECT_LT(open_after(900), 0.05F);
}

TEST(Visemes, EveryVowelHasOneAndOnlyTwoInARowGlide) {
  for (const char* vowel : {"a", "ɑ", "æ", "ɐ", "ʌ", "e", "ɛ", "i", "ɪ", "o",
                            "ɔ", "ɒ", "u", "ʊ", "ə", "ɜ", "y", "ʏ", "ø", "œ"}) {
    ASSERT_NE(viseme_of(vowel), nullptr) << vowel;
    EXPECT_FALSE(viseme_of(vowel)->closes) << vowel;
    EXPECT_EQ(glide_of(vowel), nullptr) << vowel;
    EXPECT_EQ(glide_of(vowel + std::string("ɪ")), viseme_of("ɪ")) << vowel;
  }
  EXPECT_EQ(glide_of("pɪ"), nullptr) << "no vowel comes first";
}

TEST(Visemes, TheLipsMeetOnlyForPBAndMAndTheirLike) {
  for (const char* ipa : {"p", "b", "m", "pʰ", "pf", "ɓ"}) {
    ASSERT_NE(viseme_of(ipa), nullptr) << ipa;
    EXPECT_TRUE(viseme_of(ipa)->closes) << ipa;
  }
  for (const char* ipa : {"f", "v", "w", "u", "t", "k", "n", "ŋ", ""}) {
    const Viseme* const viseme = viseme_of(ipa);
    EXPECT_FALSE(viseme != nullptr && viseme->closes) << ipa;
  }
  EXPECT_EQ(closure_before_ms("pʰ"), 50);
  EXPECT_EQ(closure_before_ms("b"), 30);
  EXPECT_EQ(closure_before_ms("m"), 0);
}

TEST(Visemes, EverySoundOfTheTableIsFoundByItsLongestSpelling) {
  EXPECT_EQ(viseme_of("tʃ")->name, "hush");
  EXPECT_EQ(viseme_of("ts")->name, "hiss");
  EXPECT_EQ(viseme_of("t"), nullptr) << "the tongue's, not the lips'";
  EXPECT_EQ(viseme_of("iː")->name, "wide");
  EXPECT_EQ(viseme_of("ɔ̃")->name, "round open");
  EXPECT_EQ(viseme_of("")->name, "pause");
  EXPECT_EQ(glide_of("iː"), nullptr);
  EXPECT_EQ(glide_of("əʊ")->name, "round");
}

}  // namespace
}  // namespace aucast::speaker
