#include "common/voice/webvtt.h"

#include <gtest/gtest.h>

namespace aucast::voice {
namespace {

using Captions = std::vector<protocol::CaptionData>;

Captions read(std::string_view text) {
  const auto read = parse_webvtt(text, "talk.vtt");
  EXPECT_TRUE(read) << read.error().message;
  return read ? *read : Captions{};
}

std::string error_of(const std::string& text) {
  const auto read = parse_webvtt(text, "talk.vtt");
  EXPECT_FALSE(read);
  return read ? "" : read.error().message;
}

TEST(Webvtt, GivesEachCueItsPlaceAndAnEndWhereNoneFollows) {
  EXPECT_EQ(read("WEBVTT\n\n"
                 "00:00:01.000 --> 00:00:02.500\nGood morning,\neverybody.\n\n"
                 "7\n00:02.500 --> 00:04.000 align:start\nToday\n\n"
                 "01:00:05.040 --> 01:00:06.000\nan hour later\n"),
            (Captions{{1000, "Good morning,\neverybody."},
                      {2500, "Today"},
                      {4000, ""},
                      {3605040, "an hour later"},
                      {3606000, ""}}));
}

TEST(Webvtt, ReadsWhatOtherProgramsWrite) {
  EXPECT_EQ(read("\xEF\xBB\xBFWEBVTT - a talk\r\nKind: captions\r\n\r\nNOTE nobody\r\nreads it\r\n"
                 "\r\nSTYLE\r\n::cue { color: red }\r\n\r\n"
                 "00:01.000 --> 00:02.000\r\n<v Ann>1 &lt; 2 &amp;\t<i>so</i> on\r\n"),
            (Captions{{1000, "1 < 2 & so on"}, {2000, ""}}));
  EXPECT_EQ(read("WEBVTT"), Captions{});
}

TEST(Webvtt, ALaterCueTakesThePlaceOfOneThatLasts) {
  EXPECT_EQ(read("WEBVTT\n\n00:03.000 --> 00:09.000\nb\n\n00:01.000 --> 00:05.000\na\n\n"
                 "00:03.000 --> 00:06.000\nc\n"),
            (Captions{{1000, "a"}, {3000, "c"}, {6000, ""}}));
}

TEST(Webvtt, ACueOfNoTimeIsNeverShown) {
  EXPECT_EQ(read("WEBVTT\n\n00:01.000 --> 00:02.000\na\n\n00:02.000 --> 00:02.000\nnobody\n"),
            (Captions{{1000, "a"}, {2000, ""}}));
}

TEST(Webvtt, SaysWhereWhatIsWrong) {
  EXPECT_EQ(error_of(""), "talk.vtt:1:1: no captions: it must begin with WEBVTT");
  EXPECT_EQ(error_of("1\n00:00:01,000 --> 00:00:02,000\nsubrip\n"),
            "talk.vtt:1:1: no captions: it must begin with WEBVTT");
  EXPECT_EQ(error_of("WEBVTTX\n"), "talk.vtt:1:1: no captions: it must begin with WEBVTT");
  EXPECT_EQ(error_of("WEBVTT\n\n1:00 --> 00:02.000\nx\n"),
            "talk.vtt:3:1: no time such as 00:01:02.345 before -->");
  EXPECT_EQ(error_of("WEBVTT\n\n00:01.000 --> 00:61.000\nx\n"),
            "talk.vtt:3:14: no time such as 00:01:02.345 after -->");
  EXPECT_EQ(error_of("WEBVTT\n\n00:02.000 --> 00:01.000\nx\n"),
            "talk.vtt:3:11: the caption ends before it begins");
  EXPECT_EQ(error_of("WEBVTT\n\n277777:46:40.001 --> 277777:46:41.000\nx\n"),
            "talk.vtt:3:1: a caption later than 277777 hours, which is as far as a stream goes");
  EXPECT_EQ(error_of("WEBVTT\n\n00:01.000 --> 277777:46:40.001\nx\n"),
            "talk.vtt:3:1: a caption later than 277777 hours, which is as far as a stream goes");
  EXPECT_EQ(read("WEBVTT\n\n277777:46:39.000 --> 277777:46:40.000\nx\n").size(), 2U);
  EXPECT_EQ(error_of("WEBVTT\n\n00:01.000 --> 00:02.000\nab\xFF\n"),
            "talk.vtt:3:1: the caption that begins here is too long, or no UTF-8 text");
  EXPECT_EQ(error_of("WEBVTT\n\n00:01.000 --> 00:02.000\n" + std::string(2000, 'x') + "\n"),
            "talk.vtt:3:1: the caption that begins here is too long, or no UTF-8 text");
}

}  // namespace
}  // namespace aucast::voice
