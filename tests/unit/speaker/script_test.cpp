#include "speaker/script.h"

#include <gtest/gtest.h>

namespace aucast::speaker {
namespace {

TEST(ParseScript, LeavesOutWhatIsNotSpoken) {
  const auto script = parse_script(
      "# title: Faces\n# a note\n[Smile] Good morning,\neverybody.\n\n  Two [fear 50] more.\n",
      "t");
  ASSERT_TRUE(script) << script.error().message;
  EXPECT_EQ(script->title, "Faces");
  EXPECT_EQ(script->title_line, 1U);
  EXPECT_EQ(script->text, " Good morning, everybody.\n\n  Two  more.\n\n");
  ASSERT_EQ(script->cues.size(), 2U);
  EXPECT_EQ(script->cues[0].name, "Smile") << "as it is written";
  EXPECT_EQ(script->cues[0].at, 0U);
  EXPECT_EQ(script->cues[1].name, "fear 50");
  EXPECT_EQ(script->cues[1].line, 6U);
  EXPECT_EQ(script->cues[1].column, 7U);
  EXPECT_EQ(script->ends.size(), 2U);
}

TEST(ParseScript, CountsCharactersAndNotBytes) {
  const auto script = parse_script("Schöne Grüße [smile] an alle", "t");
  ASSERT_TRUE(script);
  ASSERT_EQ(script->cues.size(), 1U);
  EXPECT_EQ(script->cues[0].at, 13U);
  const Characters text(script->text);
  EXPECT_EQ(text.count(), characters(script->text));
  EXPECT_EQ(text.part(7, 5), "Grüße");
  EXPECT_EQ(text.part(7, 1000), script->text.substr(8));
  EXPECT_EQ(text.part(1000, 1), "");
}

TEST(ParseScript, CuesJoinNoWords) {
  const auto script = parse_script("Hello[smile] [surprise]world.\n\n[fear] [smile]Hm[0]m.", "t");
  ASSERT_TRUE(script);
  EXPECT_EQ(script->text, "Hello world.\n\nHmm.\n\n");
  ASSERT_EQ(script->cues.size(), 5U);
  EXPECT_EQ(script->cues[0].at, 5U);
  EXPECT_EQ(script->cues[1].at, 6U);
}

TEST(ParseScript, RefusesControlCharacters) {
  using namespace std::string_view_literals;
  const auto nul = parse_script("one\ntwo\0 three\n"sv, "t.txt");
  ASSERT_FALSE(nul);
  EXPECT_EQ(nul.error().kind, ErrorKind::BadData);
  EXPECT_EQ(nul.error().message,
            "t.txt:2:4: a control character (\\x00), which cannot be spoken; delete it");
  EXPECT_FALSE(parse_script("# title: A\x1b[31m talk\none", "t"));
  EXPECT_FALSE(parse_script("one \x7f two", "t"));
  EXPECT_FALSE(parse_script("one \xc2\x85 two", "t"));
  EXPECT_TRUE(parse_script("one\ttwo\r\n\r\nthree\r\n", "t"));
}

TEST(ParseScript, EndsOfLinesAndTheMarkOfUtf8AreNoWords) {
  const auto unix_lines = parse_script("one\ntwo\n\nthree\n", "t");
  ASSERT_TRUE(unix_lines);
  EXPECT_EQ(unix_lines->text, "one two\n\nthree\n\n");
  EXPECT_EQ(unix_lines->ends, (std::vector<std::size_t>{9, 16}));
  for (const char* text : {"one\r\ntwo\r\n\r\nthree\r\n", "\xEF\xBB\xBFone\ntwo\n\nthree",
                           "one\ntwo\n \t\n\n\nthree\n\n\n"}) {
    const auto script = parse_script(text, "t");
    ASSERT_TRUE(script) << text;
    EXPECT_EQ(script->text, unix_lines->text) << text;
    EXPECT_EQ(script->ends, unix_lines->ends) << text;
  }
}

TEST(ParseScript, ACommentPartsNothingAndATitleIsOne) {
  const auto script = parse_script("one\n  # aside [no cue\ntwo\n#  TITLE:  Faces: a talk \n", "t");
  ASSERT_TRUE(script);
  EXPECT_EQ(script->text, "one two\n\n");
  EXPECT_TRUE(script->cues.empty());
  EXPECT_EQ(script->title, "Faces: a talk");
  EXPECT_EQ(script->title_line, 4U);
  const auto none = parse_script("# subtitle: no\none # two", "t");
  ASSERT_TRUE(none);
  EXPECT_EQ(none->title, "");
  EXPECT_EQ(none->text, "one # two\n\n") << "a # within a line is a word";
}

TEST(ParseScript, CuesAreTrimmedAndTheirColumnsCountBytes) {
  const auto script = parse_script("Grüße [ smile  50 ] und[]\n[fear]", "t");
  ASSERT_TRUE(script);
  ASSERT_EQ(script->cues.size(), 3U);
  EXPECT_EQ(script->cues[0].name, "smile  50");
  EXPECT_EQ(script->cues[0].column, 9U);
  EXPECT_EQ(script->cues[1].name, "");
  EXPECT_EQ(script->cues[2].line, 2U);
  EXPECT_EQ(script->cues[2].column, 1U);
  EXPECT_EQ(script->cues[2].at, characters(script->text.substr(0, script->text.find("\n"))));
}

TEST(ParseScript, ATextWithoutWordsIsEmpty) {
  for (const char* text : {"", "\n\n", "# title: only\n", "[smile]\n\n[fear]"}) {
    const auto script = parse_script(text, "t");
    ASSERT_TRUE(script) << text;
    EXPECT_EQ(script->text, "") << text;
    EXPECT_TRUE(script->ends.empty()) << text;
  }
}

TEST(ParseScript, BytesThatNoCharacterHasAreRefused) {
  for (const char* bytes : {"one \xff", "\xc0\x80", "\xed\xa0\x80", "two\xe2\x82"}) {
    const auto script = parse_script(bytes, "t");
    ASSERT_FALSE(script);
    EXPECT_NE(script.error().message.find("no UTF-8"), std::string::npos);
  }
}

TEST(ParseScript, SaysWhereATextIsWrong) {
  const auto open = parse_script("one\ntwo [smile\n", "t.txt");
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().kind, ErrorKind::BadData);
  EXPECT_EQ(open.error().message, "t.txt:2:5: a [ without its ] on the same line");

  const auto latin = parse_script(
      "one\nGr\xfc\xdf"
      "e\n",
      "t.txt");
  ASSERT_FALSE(latin);
  EXPECT_NE(latin.error().message.find("t.txt:2"), std::string::npos);
}

}  // namespace
}  // namespace aucast::speaker
