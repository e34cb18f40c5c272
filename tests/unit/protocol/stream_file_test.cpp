#include "protocol/stream_file.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "protocol/limits.h"
#include "tests/support/seeded.h"
#include "tests/unit/protocol/random_packets.h"

namespace aucast::protocol {
namespace {

using test::Seeded;

std::string in_tags(const std::string& lines) {
  return "Beg_Stream\n" + lines + "\nEnd_Stream\n";
}

/// The packets in canonical form, or the message.
std::string read(std::string_view text) {
  const auto stream = parse_stream_file(text, "f");
  if (!stream) {
    EXPECT_EQ(stream.error().kind, ErrorKind::BadData);
    return stream.error().message;
  }
  std::string packets;
  for (const Keyframe& keyframe : stream->keyframes) packets += encode(keyframe);
  return packets;
}

TEST(StreamFile, ReadsPacketsWithAndWithoutBraces) {
  EXPECT_EQ(read(in_tags("1,2,5\n{1,6,12,14}\n { 4 , 5 } ")), "{1,2,5}{1,6,12,14}{4,5}");
  EXPECT_EQ(read(in_tags("1C+4B+L12D\n\t6 + 12 ; 40 @ 0")), "{1:50,4:25,L12:80}{6,12;40@0}");
  EXPECT_EQ(read(in_tags("0")), "{0}");
}

TEST(StreamFile, AcceptsCommentsBlanksCrLfAByteOrderMarkAndNoLastNewline) {
  EXPECT_EQ(
      read("\xef\xbb\xbf# a talk, gr\xc3\xbc\xc3\x9f\r\n\r\n Beg_Stream # here\r\n1,6 # smile\r\n"
           "\r\n#2\r\n\tEnd_Stream\r\n# over"),
      "{1,6}");
  EXPECT_EQ(read("Beg_Stream\n1\nEnd_Stream"), "{1}");
}

TEST(StreamFile, KeepsTermsAsWritten) {
  const auto stream = parse_stream_file(in_tags("12,12:40,6"), "f");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->keyframes.front().terms.size(), 3U);
}

TEST(StreamFile, NamesEachErrorWithItsPlace) {
  const std::string missing =
      "the file ends without End_Stream; write it on a line of its own after the last packet";
  const std::pair<std::string, std::string> rows[] = {
      {"", "f:1:1: the file is empty"},
      {"# only\n", "f:1:1: there is no stream: Beg_Stream, packets and End_Stream are missing"},
      {"1,6\nEnd_Stream\n",
       "f:1:1: expected Beg_Stream on a line of its own before the first packet, found '1,6'"},
      {"\nEnd_Stream\n", "f:2:1: End_Stream without a Beg_Stream before it"},
      {"Beg_Stream\n1\n", "f:2:1: " + missing},
      {"Beg_Stream\n1", "f:2:1: " + missing},
      {"Beg_Stream\nEnd_Stream\n",
       "f:2:1: the stream is empty; write at least one packet between the tags, such as 1,6,12"},
      {in_tags("1") + "  2\n3\n",
       "f:4:3: text after End_Stream: '2'; only blanks and comments may follow"},
      {in_tags("1") + in_tags("2"),
       "f:4:1: found Beg_Stream after End_Stream; a file holds one stream\n"
       "f:5:1: text after End_Stream: '2'; only blanks and comments may follow\n"
       "f:6:1: found End_Stream after End_Stream; a file holds one stream"},
      {"Beg_Stream\nBeg_Stream\n1\nEnd_Stream\n",
       "f:2:1: a second Beg_Stream; the stream began on line 1"},
      {in_tags("1,6\nend_stream\n2"),
       "f:3:1: expected an AU number, L or R, found 'e'; did you mean End_Stream?"},
      {in_tags("100"), "f:2:3: an AU number is 0-99, of one or two digits"},
      {in_tags("1x2"), "f:2:3: expected ',', '+', ';' or the end, found '2'"},
      {in_tags("1 2"),
       "f:2:3: expected ':', a letter of A-E x y z, ',', '+', ';' or the end, found '2'"},
      {in_tags("  {1,}"), "f:2:6: expected an AU number, L or R, found the end"},
      {in_tags("{}"), "f:2:2: expected an AU number, L or R, found the end"},
      {in_tags("{-2}"), "f:2:2: expected an AU number, L or R, found '-'"},
      {in_tags("{1,6"), "f:2:5: the closing brace is missing"},
      {in_tags("1,6}"),
       "f:2:4: expected ':', a letter of A-E x y z, ',', '+', ';' or the end, found '}'"},
      {in_tags("{1}{2}"), "f:2:4: text after the closing brace; write one packet per line"},
      {in_tags("{~12}"), "f:2:2: a stream file names whole sets; '~' is for the wire only"},
      {in_tags("1;40@100\n2;40@99"), "f:3:5: the place goes backwards, to 99 ms after 100 ms"},
      {in_tags("1 \xc3\xbc"),
       "f:2:3: expected ':', a letter of A-E x y z, ',', '+', ';' or the end, found '\\xc3'"},
      {in_tags("1\x1b[2J"),
       "f:2:2: this is not text: found the byte '\\x1b'; a stream file is "
       "ASCII or UTF-8 text"},
      {in_tags("1 # \x07"),
       "f:2:5: this is not text: found the byte '\\x07'; a stream file is "
       "ASCII or UTF-8 text"},
  };
  for (const auto& [text, message] : rows) EXPECT_EQ(read(text), message) << text;
}

TEST(StreamFile, IsNotABinary) {
  const std::string picture("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0", 18);
  EXPECT_EQ(read(picture),
            "f:3:1: this is not text: found the byte '\\x00'; a stream file is ASCII or UTF-8 text")
      << "and nothing of the lines before and after it";
}

TEST(StreamFile, AcceptsEqualPlaces) {
  EXPECT_EQ(read(in_tags("1;40@100\n2;0@100")), "{1;40@100}{2;0@100}");
}

TEST(StreamFile, HoldsALineToItsLimit) {
  const std::string longest = "1" + std::string(kStreamLineBytesMax - 1, ' ');
  EXPECT_EQ(read(in_tags(longest)), "{1}");
  EXPECT_EQ(read(in_tags(longest + " ")),
            "f:2:65537: the line is longer than 65536 bytes; write one packet per line");
}

TEST(StreamFile, ReportsTheFirstErrorsAndCountsTheRest) {
  std::string lines = "1";
  for (int i = 0; i < 25; ++i) lines += "\nx";
  const std::string message = read(in_tags(lines));
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 20);
  EXPECT_TRUE(message.starts_with("f:3:1: ")) << message;
  EXPECT_TRUE(message.ends_with("\nf: and 5 more errors")) << message;
}

TEST(StreamFile, RoundTripsThroughItsTextForm) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 200; ++run) {
    StreamFile stream;
    std::uint64_t place_ms = 0;
    for (int i = seeded.integer(1, 20); i > 0; --i) {
      Keyframe keyframe = test::random_keyframe(seeded);
      if (keyframe.changes_only) continue;
      if (keyframe.place_ms) keyframe.place_ms = place_ms += 40;
      stream.keyframes.push_back(keyframe);
    }
    if (stream.keyframes.empty()) continue;
    const auto again = parse_stream_file(format_stream_file(stream), "f");
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_EQ(again->keyframes, stream.keyframes);
  }
}

TEST(MendStreamText, KeepsWhatIsWholeAndEndsIt) {
  const std::string whole = "# talk\nBeg_Stream\n1;40 # brows\n\n2;33\nEnd_Stream\n";
  EXPECT_EQ(mend_stream_text(whole).text, whole);
  EXPECT_EQ(mend_stream_text(whole).lines_left_out, 0U);
  for (const char* torn : {"12:5", "12:5;33\nEnd_Str", "", "12:5;33\n12:;\n6\n6\nEnd_Stream\n"}) {
    const auto mended = mend_stream_text("Beg_Stream\n1;40\n" + std::string(torn));
    const auto stream = parse_stream_file(mended.text, "f");
    ASSERT_TRUE(stream.has_value()) << torn << stream.error().message;
    EXPECT_EQ(stream->keyframes.size(), std::string(torn).starts_with("12:5;33\n") ? 2U : 1U);
  }
  EXPECT_EQ(mend_stream_text("Beg_Stream\n1;40\n12:;\n6\n6").lines_left_out, 3U);
  const std::string zeros(3, '\0');
  EXPECT_EQ(mend_stream_text("Beg_Stream\n1;40\n" + zeros).lines_left_out, 1U);
}

TEST(MendStreamText, AByteOrderMarkIsNoPartOfTheFirstLine) {
  const auto mended = mend_stream_text(
      "\xef\xbb\xbf"
      "Beg_Stream\n1;40\n6");
  EXPECT_EQ(mended.text, "Beg_Stream\n1;40\nEnd_Stream\n");
  EXPECT_EQ(mended.lines_left_out, 1U);
}

TEST(MendStreamText, OfAFileThatWasCutAnywhereOnlyWhatWasCutIsLost) {
  const std::string whole = "Beg_Stream\n1:20;40\nL2:33,R2:5;33\n0;33\nEnd_Stream\n";
  const auto all = parse_stream_file(whole, "f")->keyframes;
  for (std::size_t size = whole.find('\n', 11) + 1; size <= whole.size(); ++size) {
    const auto stream = parse_stream_file(mend_stream_text(whole.substr(0, size)).text, "f");
    ASSERT_TRUE(stream.has_value()) << size;
    const auto lines =
        std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size), '\n');
    EXPECT_EQ(stream->keyframes.size(),
              std::min<std::size_t>(static_cast<std::size_t>(lines) - 1, 3))
        << size;
    EXPECT_TRUE(std::equal(stream->keyframes.begin(), stream->keyframes.end(), all.begin()));
  }
}

TEST(MediaMs, CountsUntimedKeyframesWithTheDefault) {
  const auto stream = parse_stream_file(in_tags("1;40\n2\n3;0\n4;60"), "f");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(media_ms(*stream, 250), 350U);
}

TEST(StreamFile, RoomForItsKeyframesIsMadeOnce) {
  std::string text = "Beg_Stream\n";
  for (int line = 0; line < 1000; ++line) text += "1\n";
  const auto stream = parse_stream_file(text + "End_Stream\n", "f");
  ASSERT_TRUE(stream);
  EXPECT_EQ(stream->keyframes.size(), 1000U);
  EXPECT_LE(stream->keyframes.capacity(), 1002U) << "growing takes three times as much memory";
}

TEST(ReadStreamFile, EndsWithTheErrorOfItsSink) {
  std::size_t taken = 0;
  const auto read =
      read_stream_file(in_tags("1\n2\n3\nnonsense"), "f", [&taken](Keyframe&&) -> Result<void> {
        if (++taken == 2) return Error{ErrorKind::Failed, "enough"};
        return {};
      });
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "enough");
  EXPECT_EQ(taken, 2U);
}

TEST(StreamTitle, IsACommentBeforeTheFirstPacket) {
  EXPECT_EQ(stream_title("# title: A talk \r\nBeg_Stream\n1\nEnd_Stream\n").text, "A talk");
  EXPECT_EQ(
      stream_title("\xEF\xBB\xBF# by hand\n\nBeg_Stream # of it\n  #title:Two words\n1\n").text,
      "Two words");
  EXPECT_EQ(stream_title("# Title: Any case\nBeg_Stream\n1\nEnd_Stream\n").text, "Any case");
  EXPECT_EQ(stream_title("Beg_Stream\n1\n# title: too late\nEnd_Stream\n").text, "");
  EXPECT_EQ(stream_title("# titles: none\nBeg_Stream\n").text, "");
  EXPECT_EQ(stream_title("").text, "");
  EXPECT_EQ(stream_title("\n# by hand\n# title: A talk\nBeg_Stream\n").line, 3U);
}

}  // namespace
}  // namespace aucast::protocol
