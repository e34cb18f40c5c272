#include "speaker/alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
    spoken.clause_ends.emplace_back(at);
  }
  // The reader leaves out the middle.
  const Speech read = carried_over(spoken, tones({200, 250}, {200, 300}, 16000), 16000).speech;
  ASSERT_EQ(read.words.size(), spoken.words.size());
  for (std::size_t i = 1; i < read.words.size(); ++i) {
    EXPECT_GE(read.words[i].begin, read.words[i - 1].begin) << i;
    EXPECT_GE(read.clause_ends[i], read.clause_ends[i - 1]) << i;
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
  EXPECT_EQ(carried_over(spoken, std::vector<float>(10), 16000).likeness, 0) << "no window";
}

TEST(Align, ASoundWithItselfIsTheDiagonal) {
  const auto sound = cepstrum_of(tones({200, 900, 400}, {300, 300, 300}, 16000), 16000);
  for (const auto& [a, b] : align(sound, sound)) EXPECT_EQ(a, b);
}

/// Windows of which each differs from its neighbours.
Cepstrum windows(std::size_t count) {
  Cepstrum cepstrum;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < Cepstrum::kCoefficients; ++k) {
      cepstrum.rows.push_back(std::sin(0.37F * static_cast<float>(i * (k + 1))));
    }
  }
  return cepstrum;
}

TEST(Align, APathGoesFromBothBeginningsToBothEndsWithoutALeap) {
  // Up to four times as long is what a narration may be; beyond it no memory may be touched.
  for (const auto& [a, b] : std::vector<std::pair<std::size_t, std::size_t>>{{1, 1},
                                                                             {1, 3000},
                                                                             {3000, 1},
                                                                             {2, 2000},
                                                                             {40, 30'000},
                                                                             {500, 2000},
                                                                             {2000, 500},
                                                                             {3000, 2999},
                                                                             {30'000, 41}}) {
    const AlignmentPath path = align(windows(a), windows(b));
    ASSERT_FALSE(path.empty()) << a << " and " << b;
    EXPECT_EQ(path.front(), (std::pair<std::size_t, std::size_t>(0, 0)));
    EXPECT_EQ(path.back(), (std::pair<std::size_t, std::size_t>(a - 1, b - 1)));
    for (std::size_t i = 1; i < path.size(); ++i) {
      const std::size_t of_a = path[i].first - path[i - 1].first;
      const std::size_t of_b = path[i].second - path[i - 1].second;
      ASSERT_TRUE(of_a <= 1 && of_b <= 1 && of_a + of_b >= 1) << a << " and " << b << " at " << i;
    }
  }
}

TEST(Align, SamplesThatAreNoNumbersHaveNoPath) {
  const auto sound = cepstrum_of(tones({200, 900, 400}, {300, 300, 300}, 16000), 16000);
  for (const float odd :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30F}) {
    std::vector<float> samples = tones({200, 900, 400}, {300, 300, 300}, 16000);
    samples[samples.size() / 2] = odd;
    const auto broken = cepstrum_of(samples, 16000);
    EXPECT_TRUE(align(sound, broken).empty()) << odd;
    EXPECT_TRUE(align(broken, sound).empty()) << odd;
    Speech spoken;
    spoken.samples.resize(22050);
    spoken.words = {{Milliseconds(100), 0, 1}, {Milliseconds(5000), 2, 1}};
    const CarriedOver carried = carried_over(spoken, samples, 16000);
    EXPECT_EQ(carried.likeness, 0) << odd;
    EXPECT_LE(carried.speech.words.back().begin, carried.speech.length()) << odd;
  }
}

TEST(CepstrumOf, HasAWindowEachHundredthOfASecondThatFitsWhole) {
  for (const int rate : {16000, 22050, 48000}) {
    const auto ms = [rate](int time) { return static_cast<std::size_t>(time * rate / 1000); };
    const auto count = [rate](std::size_t samples) {
      return cepstrum_of(std::vector<float>(samples, 0.1F), rate).windows();
    };
    EXPECT_EQ(count(ms(32) - 1), 0U) << rate;
    EXPECT_EQ(count(ms(32)), 1U) << rate;
    EXPECT_EQ(count(ms(32) + ms(10)), 2U) << rate;
    EXPECT_EQ(count(ms(1000)), 97U) << rate;
  }
}

TEST(CepstrumOf, EachCoefficientHasMeanZeroAndDeviationOne) {
  const auto sound = cepstrum_of(tones({200, 900, 400, 1500}, {300, 200, 400, 300}, 16000), 16000);
  for (std::size_t k = 0; k < Cepstrum::kCoefficients; ++k) {
    double sum = 0;
    double squares = 0;
    for (std::size_t i = k; i < sound.rows.size(); i += Cepstrum::kCoefficients) {
      sum += static_cast<double>(sound.rows[i]);
      squares += std::pow(static_cast<double>(sound.rows[i]), 2);
    }
    const auto n = static_cast<double>(sound.windows());
    EXPECT_NEAR(sum / n, 0, 1e-4) << k;
    EXPECT_NEAR(squares / n, 1, 1e-3) << k;
  }
}

TEST(CepstrumOf, ALouderRecordingIsTheSameSound) {
  const std::vector<float> quiet = tones({200, 900, 400}, {300, 300, 300}, 16000);
  std::vector<float> loud = quiet;
  for (float& sample : loud) sample *= 2;
  const Cepstrum a = cepstrum_of(quiet, 16000);
  const Cepstrum b = cepstrum_of(loud, 16000);
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t i = 0; i < a.rows.size(); ++i) EXPECT_NEAR(a.rows[i], b.rows[i], 0.15F) << i;
}

TEST(CarriedOver, WordsKeepTheirPlaceInTheTextAndSoundsTheirLetters) {
  Speech spoken;
  spoken.samples = tones({200, 900}, {400, 400}, spoken.rate);
  spoken.phonemes = {{"a", Milliseconds(0)}, {"", Milliseconds(380)}, {"i", Milliseconds(400)}};
  spoken.words = {{Milliseconds(0), 3, 5}, {Milliseconds(400), 9, 2}};
  const Speech read = carried_over(spoken, tones({200, 900}, {400, 400}, 16000), 16000).speech;
  EXPECT_EQ(read.rate, 16000);
  ASSERT_EQ(read.phonemes.size(), 3U);
  EXPECT_EQ(read.phonemes[1].ipa, "");
  EXPECT_EQ(read.phonemes[2].ipa, "i");
  ASSERT_EQ(read.words.size(), 2U);
  EXPECT_EQ(read.words[1].at, 9U);
  EXPECT_EQ(read.words[1].length, 2U);
  EXPECT_NEAR(static_cast<double>(read.words[1].begin.count()), 400, 30);
}

TEST(Align, ASoundTooShortForAWindowHasNoPath) {
  const std::vector<float> short_sound(10);
  EXPECT_TRUE(align(cepstrum_of(short_sound, 16000), cepstrum_of(short_sound, 16000)).empty());
}

}  // namespace
}  // namespace aucast::speaker
