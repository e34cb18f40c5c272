#include "speaker/alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace aucast::speaker {
namespace {

/// Rising tones of `ms` each, as a voice whose sounds are told apart and never stand still.
std::vector<float> tones(const std::vector<int>& hertz, const std::vector<int>& ms, int rate) {
  std::vector<float> samples;
  for (std::size_t k = 0; k < hertz.size(); ++k) {
    const int count = ms[k] * rate / 1000;
    double phase = 0;
    for (int i = 0; i < count; ++i) {
      phase += 2 * std::numbers::pi * hertz[k] * (1 + 0.6 * i / count) / rate;
      double sum = 0;
      for (int overtone = 1; overtone < 6; ++overtone) {
        sum += std::sin(overtone * phase) / overtone;
      }
      samples.push_back(static_cast<float>(0.2 * sum));
    }
  }
  return samples;
}

TEST(CarriedOver, FindsTheSoundsOfASlowerVoiceAtAnotherRate) {
  const std::vector<int> hertz{200, 900, 400, 1500, 300, 700, 1200, 250};
  const std::vector<int> spoken_ms{200, 250, 150, 300, 200, 180, 260, 300};
  const std::vector<int> read_ms{400, 260, 300, 310, 350, 240, 410, 300};
  Speech spoken;
  spoken.samples = tones(hertz, spoken_ms, spoken.rate);
  int at = 0;
  for (const int ms : spoken_ms) {
    spoken.phonemes.push_back({"a", Milliseconds(at)});
    at += ms;
  }
  const CarriedOver carried = carried_over(spoken, tones(hertz, read_ms, 16000), 16000);
  const Speech& read = carried.speech;
  ASSERT_EQ(read.phonemes.size(), hertz.size());
  at = 0;
  for (std::size_t i = 0; i < hertz.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(read.phonemes[i].begin.count()), at, 30) << "tone " << i;
    at += read_ms[i];
  }
}

TEST(CarriedOver, SkippedWordsKeepTheirOrder) {
  const std::vector<int> hertz{200, 900, 400, 1500, 300, 700, 1200, 250};
  const std::vector<int> ms{200, 250, 150, 300, 200, 180, 260, 300};
  Speech spoken;
  spoken.samples = tones(hertz, ms, spoken.rate);
  for (int at = 0; at < spoken.length().count(); at += 7) {
    const auto order = spoken.words.size();
    spoken.words.push_back({Milliseconds(at), 2 * order, 1});
    spoken.sentence_ends.emplace_back(at);
  }
  // The reader leaves out the middle.
  const Speech read = carried_over(spoken, tones({200, 250}, {200, 300}, 16000), 16000).speech;
  ASSERT_EQ(read.words.size(), spoken.words.size());
  for (std::size_t i = 1; i < read.words.size(); ++i) {
    EXPECT_GE(read.words[i].begin, read.words[i - 1].begin) << i;
    EXPECT_GE(read.sentence_ends[i], read.sentence_ends[i - 1]) << i;
  }
  EXPECT_LE(read.words.back().begin, read.length());
}

TEST(CarriedOver, NothingIsLaterThanANarrationThatIsTooShort) {
  Speech spoken;
  spoken.samples.resize(22050);
  spoken.words = {{Milliseconds(0), 0, 1}, {Milliseconds(900), 2, 1}};
  const Speech read = carried_over(spoken, std::vector<float>(160), 16000).speech;
  EXPECT_EQ(read.words.back().begin, read.length());
}

TEST(CarriedOver, TellsHowAlikeBothAre) {
  Speech spoken;
  spoken.samples = tones({200, 900, 400, 1500}, {300, 300, 300, 300}, spoken.rate);
  EXPECT_GT(carried_over(spoken, spoken.samples, spoken.rate).likeness, 0.999F);
  EXPECT_EQ(carried_over(spoken, std::vector<float>(64000), 16000).likeness, 0) << "silence";
  EXPECT_EQ(carried_over(spoken, std::vector<float>(10), 16000).likeness, 0) << "no frame";
}

TEST(Align, ASoundWithItselfIsTheDiagonal) {
  const auto sound = cepstrum_of(tones({200, 900, 400}, {300, 300, 300}, 16000), 16000);
  for (const auto& [a, b] : align(sound, sound)) EXPECT_EQ(a, b);
}

TEST(Align, ASoundTooShortForAFrameHasNoPath) {
  const std::vector<float> short_sound(10);
  EXPECT_TRUE(align(cepstrum_of(short_sound, 16000), cepstrum_of(short_sound, 16000)).empty());
}

}  // namespace
}  // namespace aucast::speaker
