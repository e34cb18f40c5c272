#include "speaker/lips.h"

#include <gtest/gtest.h>

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
    EXPECT_GT(at(curves, 24, ms), 0.2F) << ms;
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
  EXPECT_GT(at(curves, 32, 340), 0.5F);
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
