#include "speaker/espeak_voice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "common/text.h"
#include "speaker/script.h"

namespace aucast::speaker {
namespace {

const std::string kSentences =
    "Good morning, Zoë. Faces have more than forty muscles.\n\nDo they?\n\n";

Speech said(const std::string& text, const VoiceOptions& options = {}) {
  auto speech = speak(text, options);
  EXPECT_TRUE(speech) << speech.error().message;
  return speech ? *std::move(speech) : Speech{};
}

TEST(Speak, TellsWhichWordsOfTheTextAreHeardWhen) {
  const Speech speech = said(kSentences);
  const Characters text(kSentences);
  std::vector<std::string> words;
  for (const Word& word : speech.words) words.emplace_back(text.part(word.at, word.length));
  EXPECT_EQ(words, (std::vector<std::string>{"Good", "morning", "Zoë", "Faces", "have", "more",
                                             "than", "forty", "muscles", "Do", "they"}));
  for (std::size_t i = 1; i < speech.words.size(); ++i) {
    EXPECT_GT(speech.words[i].begin, speech.words[i - 1].begin) << i;
  }
  EXPECT_LT(speech.words.back().begin, speech.length());
}

TEST(Speak, SoundsComeInOrderAndNoTwoPausesInARow) {
  const Speech speech = said(kSentences);
  ASSERT_GT(speech.phonemes.size(), 30U);
  for (std::size_t i = 1; i < speech.phonemes.size(); ++i) {
    EXPECT_GE(speech.phonemes[i].begin, speech.phonemes[i - 1].begin) << i;
    EXPECT_FALSE(speech.phonemes[i].ipa.empty() && speech.phonemes[i - 1].ipa.empty()) << i;
    EXPECT_FALSE(speech.phonemes[i].ipa.starts_with('_')) << "espeak-ng's sign of a pause";
  }
  EXPECT_LE(speech.phonemes.back().begin, speech.length());
}

TEST(Speak, EveryClauseHasAnEnd) {
  const Speech speech = said(kSentences);
  const Characters text(kSentences);
  std::vector<std::string> last_words;
  for (const Milliseconds end : speech.clause_ends) {
    const auto after = std::find_if(speech.words.begin(), speech.words.end(),
                                    [end](const Word& word) { return word.begin >= end; });
    ASSERT_NE(after, speech.words.begin());
    last_words.emplace_back(text.part(std::prev(after)->at, std::prev(after)->length));
  }
  EXPECT_EQ(last_words, (std::vector<std::string>{"morning", "Zoë", "muscles", "they"}));
  EXPECT_LE(speech.clause_ends.back(), speech.length());
}

TEST(Speak, SamplesAreASoundWithinItsBounds) {
  const Speech speech = said(kSentences);
  const auto [least, most] = std::minmax_element(speech.samples.begin(), speech.samples.end());
  EXPECT_GE(*least, -1);
  EXPECT_LE(*most, 1);
  EXPECT_GT(*most - *least, 0.2F) << "somebody is heard";
}

TEST(Speak, GoesAsFastAsItIsAsked) {
  const auto length = [](int words_per_minute) {
    return said(kSentences, {.words_per_minute = words_per_minute}).length();
  };
  EXPECT_GT(length(100), length(150) + Milliseconds(500));
  EXPECT_GT(length(150), length(250) + Milliseconds(500));
}

TEST(Speak, AVoiceGoesByItsNameOrItsLanguage) {
  EXPECT_FALSE(said("Guten Morgen", {.language = "de"}).words.empty());
  EXPECT_FALSE(said("Guten Morgen", {.language = "German"}).words.empty());
  const auto unknown = speak("Good morning", {.language = "no\nvoice"});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().kind, ErrorKind::Usage);
  EXPECT_EQ(unknown.error().message,
            "espeak-ng has no voice 'no\\x0avoice'; --list-voices names them");
  EXPECT_FALSE(said("Good morning").words.empty()) << "the library goes on";
}

TEST(Voices, AreListedByLanguageAndName) {
  const auto names = voices();
  ASSERT_TRUE(names) << names.error().message;
  EXPECT_GT(names->size(), 50U);
  for (const std::string& name : *names) {
    const auto parts = split(name, '\t');
    ASSERT_EQ(parts.size(), 2U) << name;
    EXPECT_FALSE(parts[0].empty() || parts[1].empty()) << name;
  }
  EXPECT_TRUE(std::any_of(names->begin(), names->end(),
                          [](const std::string& name) { return name.starts_with("de\t"); }));
}

}  // namespace
}  // namespace aucast::speaker
