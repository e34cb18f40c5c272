#include "speaker/captions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "common/text.h"
#include "common/voice/webvtt.h"
#include "speaker/espeak_voice.h"

namespace aucast::speaker {
namespace {

Speech words_every(int ms, const Script& script) {
  Speech speech;
  std::size_t at = 0;
  Milliseconds begin{0};
  while (at < script.text.size()) {
    const std::size_t end = std::min(script.text.find_first_of(" \n", at), script.text.size());
    if (end > at) {
      speech.words.push_back({begin, at, end - at});
      begin += Milliseconds(ms);
    }
    at = end + 1;
  }
  speech.samples.resize(static_cast<std::size_t>(begin.count()) * 22050 / 1000);
  return speech;
}

void expect_short_lines(const std::string& caption) {
  const auto lines = split(caption, '\n');
  EXPECT_LE(lines.size(), 2U) << caption;
  for (const std::string_view line : lines) EXPECT_LE(characters(line), 42U) << caption;
}

TEST(Captions, EndWithTheSentence) {
  const auto script = parse_script("Good morning. How are you?", "t");
  ASSERT_TRUE(script);
  const auto captions = captions_of(words_every(300, *script), *script);
  ASSERT_EQ(captions.size(), 2U);
  EXPECT_EQ(captions[0].text, "Good morning.");
  EXPECT_EQ(captions[1].text, "How are you?");
  EXPECT_EQ(captions[1].begin, Milliseconds(600));
  EXPECT_GE(captions[1].end, Milliseconds(1200));
}

TEST(Captions, HaveTwoLinesOfFortyTwoCharactersAtMost) {
  std::string text;
  for (int i = 0; i < 60; ++i) text += "words and ";
  const auto script = parse_script(text, "t");
  ASSERT_TRUE(script);
  const auto captions = captions_of(words_every(200, *script), *script);
  EXPECT_GT(captions.size(), 5U);
  for (const TimedCaption& caption : captions) {
    expect_short_lines(caption.text);
  }
}

TEST(Captions, ABreakLeavesNoLineTooLong) {
  const std::string word(16, 'w');
  // The blank nearest to the middle stands after 47 characters.
  const auto script = parse_script(std::string(30, 'a') + " " + word + " " + word + " end.", "t");
  ASSERT_TRUE(script);
  const auto captions = captions_of(words_every(200, *script), *script);
  ASSERT_EQ(captions.size(), 1U);
  EXPECT_EQ(captions[0].text, std::string(30, 'a') + "\n" + word + " " + word + " end.");

  const auto three = parse_script(
      std::string(30, 'a') + " " + std::string(20, 'b') + " " + std::string(30, 'c'), "t");
  ASSERT_TRUE(three);
  for (const TimedCaption& caption : captions_of(words_every(200, *three), *three)) {
    expect_short_lines(caption.text);
  }
}

TEST(Captions, AreWhatIsWritten) {
  const auto text_of = [](const std::string& written, const std::string& language) {
    const auto script = parse_script(written, "t");
    EXPECT_TRUE(script);
    const auto speech = speak(script->text, {.language = language});
    EXPECT_TRUE(speech);
    std::string text;
    for (const TimedCaption& caption : captions_of(*speech, *script)) text += caption.text;
    return text;
  };
  for (const std::string written : {"It costs $5.50 now", "2024-05-01", "3/4 of them",
                                    "(and others) \"know\"", "« Vous savez ? »", "well — known"}) {
    EXPECT_EQ(text_of(written, "en"), written);
  }
  EXPECT_EQ(text_of("你好，我是人", "cmn"), "你好，我是人");
}

TEST(Captions, MarksStayWithTheirSentence) {
  const auto script = parse_script("Really ? - One thing. - Another.", "t");
  ASSERT_TRUE(script);
  Speech speech;
  speech.samples.resize(88200);
  speech.words = {{Milliseconds(0), 0, 6},
                  {Milliseconds(500), 11, 3},
                  {Milliseconds(1000), 15, 5},
                  {Milliseconds(3000), 24, 7}};
  const auto captions = captions_of(speech, *script);
  ASSERT_EQ(captions.size(), 3U);
  EXPECT_EQ(captions[0].text, "Really ?");
  EXPECT_EQ(captions[1].text, "- One thing.");
  EXPECT_EQ(captions[1].begin, Milliseconds(500));
  EXPECT_EQ(captions[2].text, "- Another.");
  EXPECT_EQ(captions[2].begin, Milliseconds(3000));
}

TEST(Captions, HaveNoEmptyLineWhereOnlyMarksStandInAParagraph) {
  const auto script = parse_script("Before\n\n* * *\n\nafter.", "t");
  ASSERT_TRUE(script);
  Speech speech;
  speech.samples.resize(44100);
  speech.words = {{Milliseconds(0), 0, 6}, {Milliseconds(500), script->text.find("after"), 5}};
  const auto captions = captions_of(speech, *script);
  ASSERT_EQ(captions.size(), 1U);
  EXPECT_EQ(captions[0].text, "Before * * * after.");
}

TEST(Captions, AWordThatIsTooLongIsCutBetweenCharacters) {
  std::string word;
  for (int i = 0; i < 1100; ++i) word += "\u00e9";
  const auto script = parse_script("One " + word + " more.", "t");
  ASSERT_TRUE(script);
  const auto captions = captions_of(words_every(300, *script), *script);
  ASSERT_EQ(captions.size(), 3U);
  EXPECT_EQ(captions[1].text, word.substr(0, 752));
  EXPECT_EQ(captions[2].text, "more.");
  EXPECT_TRUE(voice::parse_webvtt(format_webvtt(captions), "t.vtt"));
}

TEST(Captions, ASilenceParts) {
  const auto script = parse_script("one two three", "t");
  ASSERT_TRUE(script);
  Speech speech;
  speech.samples.resize(std::size_t{22050} * 8);
  speech.words = {{Milliseconds(0), 0, 3}, {Milliseconds(500), 4, 3}, {Milliseconds(4000), 8, 5}};
  const auto captions = captions_of(speech, *script);
  ASSERT_EQ(captions.size(), 2U);
  EXPECT_EQ(captions[0].text, "one two");
  EXPECT_EQ(captions[0].end, Milliseconds(2000))
      << "no longer than 1.5 s after its last word began";
  EXPECT_EQ(captions[1].begin, Milliseconds(4000));
  EXPECT_EQ(captions[1].end, Milliseconds(5500));
}

TEST(Captions, NoneBeginsBeforeTheOneBeforeItEnds) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += "Some words, and then more of them. Again! ";
  const auto script = parse_script(text, "t");
  ASSERT_TRUE(script);
  const auto captions = captions_of(words_every(90, *script), *script);
  ASSERT_GT(captions.size(), 40U);
  Milliseconds end{0};
  for (const TimedCaption& caption : captions) {
    EXPECT_GE(caption.begin, end) << caption.text;
    EXPECT_LT(caption.begin, caption.end) << caption.text;
    end = caption.end;
  }
}

TEST(Captions, AScriptWithoutBlanksIsBrokenBetweenCharacters) {
  std::string written;
  for (int i = 0; i < 120; ++i) written += "人";
  const auto script = parse_script(written, "t");
  ASSERT_TRUE(script);
  Speech speech;
  for (std::size_t i = 0; i < 120; ++i) {
    speech.words.push_back({Milliseconds(200 * static_cast<int>(i)), i, 1});
  }
  speech.samples.resize(std::size_t{22050} * 24);
  std::string all;
  for (const TimedCaption& caption : captions_of(speech, *script)) {
    expect_short_lines(caption.text);
    for (const std::string_view line : split(caption.text, '\n')) all += line;
  }
  EXPECT_EQ(all, written) << "nothing is lost where a line ends";
}

TEST(Captions, LinesAreOfTheMostEqualLengths) {
  const auto script = parse_script("It is never clear where a line of such a length ends", "t");
  ASSERT_TRUE(script);
  const auto captions = captions_of(words_every(200, *script), *script);
  ASSERT_EQ(captions.size(), 1U);
  EXPECT_EQ(captions[0].text, "It is never clear where a\nline of such a length ends");
}

TEST(Captions, ATextWithoutWordsHasNone) {
  const auto script = parse_script("\n\n", "t");
  ASSERT_TRUE(script);
  EXPECT_TRUE(captions_of({}, *script).empty());
  EXPECT_EQ(format_webvtt({}), "WEBVTT\n");
}

TEST(WebVtt, OddTextComesBackAsItWas) {
  const std::string odd = "1 < 2 & <b>x</b> --> &lt;\nAT&T";
  const std::string file = format_webvtt({{Milliseconds(1000), Milliseconds(2000), odd}});
  const auto read = voice::parse_webvtt(file, "t.vtt");
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ(read->front().text, odd);
}

TEST(WebVtt, HasItsForm) {
  EXPECT_EQ(format_webvtt({{Milliseconds(0), Milliseconds(3723004), "Hello"}}),
            "WEBVTT\n\n00:00:00.000 --> 01:02:03.004\nHello\n");
}

}  // namespace
}  // namespace aucast::speaker
