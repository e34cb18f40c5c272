#include <gtest/gtest.h>

#include "protocol/codec.h"

namespace aucast::protocol {
namespace {

constexpr std::string_view kAuExpected = "expected an AU number, L or R, found ";

/// The canonical packet of a text that must be legal.
std::string read(std::string_view text, TermSyntax syntax) {
  Keyframe keyframe;
  const auto error = parse_keyframe(text, syntax, keyframe);
  if (error) return "column " + std::to_string(error->position) + ": " + error->reason;
  return encode(keyframe);
}

TextError refused(std::string_view text, TermSyntax syntax) {
  Keyframe keyframe;
  return parse_keyframe(text, syntax, keyframe).value_or(TextError{9999, "accepted"});
}

TEST(ParseKeyframe, ReadsTheFormsOfTheWire) {
  EXPECT_EQ(read("1,6,12,14", TermSyntax::Wire), "{1,6,12,14}");
  EXPECT_EQ(read("01,00", TermSyntax::Wire), "{1}") << "leading zeros";
  EXPECT_EQ(read("0", TermSyntax::Wire), "{0}");
  EXPECT_EQ(read("1:30,R12:80,L14:50;40@73400", TermSyntax::Wire), "{1:30,R12:80,L14:50;40@73400}");
  EXPECT_EQ(read("12A,13B,14C,15D,16E", TermSyntax::Wire), "{12:10,13:25,14:50,15:80,16}");
  EXPECT_EQ(read("12x,13y,L14z", TermSyntax::Wire), "{12:25,13:60,L14}");
  EXPECT_EQ(read("~12:80,6:0;33", TermSyntax::Wire), "{~6:0,12:80;33}");
  EXPECT_EQ(read("~;33", TermSyntax::Wire), "{~;33}");
  EXPECT_EQ(read("~", TermSyntax::Wire), "{~}");
  EXPECT_EQ(read("12:080;0@0", TermSyntax::Wire), "{12:80;0@0}");
  EXPECT_EQ(read("99:100;3600000@1000000000000", TermSyntax::Wire), "{99;3600000@1000000000000}");
}

TEST(ParseKeyframe, AcceptsBlanksAroundEveryToken) {
  EXPECT_EQ(read(" 1 ,\r\n 6 ", TermSyntax::Wire), "{1,6}");
  EXPECT_EQ(read(" ~ L 12 : 80 , 4 C , 6 ; 33 @ 99 ", TermSyntax::Wire), "{~4:50,6,L12:80;33@99}");
}

TEST(ParseKeyframe, TextTakesPlusAndTabsBesides) {
  EXPECT_EQ(read("1C+4B + L12D,\t6", TermSyntax::Text), "{1:50,4:25,6,L12:80}");
  EXPECT_EQ(read("L12:80,4C;40@120", TermSyntax::Text), "{4:50,L12:80;40@120}");
  EXPECT_EQ(refused("1+4", TermSyntax::Wire).position, 1U);
  EXPECT_EQ(refused("1,\t4", TermSyntax::Wire).position, 2U);
}

TEST(ParseKeyframe, RefusesEachWrongByteWhereItStands) {
  struct Row {
    std::string_view text;
    std::size_t position;
    std::string reason;
  };
  const std::string au(kAuExpected);
  const std::string after_au = "expected ':', a letter of A-E x y z, ',', ';' or the end, found ";
  const Row rows[] = {
      {"", 0, au + "the end"},
      {"1,", 2, au + "the end"},
      {",1", 0, au + "','"},
      {"1,,2", 2, au + "','"},
      {"-2", 0, au + "'-'"},
      {";40", 0, au + "';'"},
      {"1x2", 2, "expected ',', ';' or the end, found '2'"},
      {"1 2", 2, after_au + "'2'"},
      {"12F", 2, after_au + "'F'"},
      {"12a", 2, after_au + "'a'"},
      {"12\x01", 2, after_au + "'\\x01'"},
      {"1~", 1, after_au + "'~'"},
      {"100", 2, "an AU number is 0-99, of one or two digits"},
      {"001", 2, "an AU number is 0-99, of one or two digits"},
      {"L", 1, "expected an AU number, found the end"},
      {"LR12", 1, "expected an AU number, found 'R'"},
      {"l12", 0, au + "'l'"},
      {"12:", 3, "expected a percent, found the end"},
      {"12:C", 3, "expected a percent (a letter stands without ':', as in 12C), found 'C'"},
      {"12:101", 5, "an intensity is 0-100 percent"},
      {"12:0100", 6, "an intensity is 0-100 percent"},
      {"12:8:8", 4, "expected ',', ';' or the end, found ':'"},
      {"12C:80", 3, "expected ',', ';' or the end, found ':'"},
      {"12;", 3, "expected a time in milliseconds, found the end"},
      {"12;3600001", 9, "the time of a keyframe is 0-3600000 ms (an hour)"},
      {"12;40;40", 5, "expected '@' or the end, found ';'"},
      {"12;40,6", 5, "expected '@' or the end, found ','"},
      {"12@40", 2, after_au + "'@'"},
      {"12;40@", 6, "expected a place in milliseconds, found the end"},
      {"12;40@1000000000001", 18, "a place in the stream is 0-1000000000000 ms"},
      {"12;40@1@", 7, "expected the end, found '@'"},
      {"~~", 1, "expected an AU number, L, R or ';', found '~'"},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(refused(row.text, TermSyntax::Wire), (TextError{row.position, row.reason}))
        << row.text << ": " << refused(row.text, TermSyntax::Wire).reason;
  }
}

TEST(ParseAuSet, ReadsWhatPeopleType) {
  const auto text = [](std::string_view typed) {
    const auto frame = parse_au_set(typed);
    return frame ? format_au_set(*frame) : frame.error().message;
  };
  EXPECT_EQ(text("1,6,12"), "1,6,12");
  EXPECT_EQ(text("12:80,R14:50"), "12:80,R14:50");
  EXPECT_EQ(text("{4C+9}"), "4:50,9");
  EXPECT_EQ(text(" { 4C + 9 } "), "4:50,9");
  EXPECT_EQ(text("0"), "0");
  EXPECT_EQ(text("12,12:0"), "0");
  EXPECT_EQ(text("L46,R46"), "L46,R46") << "both eyes";
  EXPECT_EQ(text("46"), "R46");
}

TEST(ParseAuSet, ReadsFacsNamesForNumbers) {
  const auto text = [](std::string_view typed) {
    const auto frame = parse_au_set(typed);
    return frame ? format_au_set(*frame) : frame.error().message;
  };
  EXPECT_EQ(text("Inner Brow Raiser,lip corner puller:80"), "1,12:80");
  EXPECT_EQ(text("{ Left Wink , R Dimpler:50, 4C}"), "4:50,R14:50,L46");
  EXPECT_EQ(text("Lid Tightener"), "7") << "L is the side only where it stands alone";
  EXPECT_EQ(text("1,smile"),
            "AU set '1,smile', column 3: 'smile' is not the FACS name of an AU, such as Inner Brow "
            "Raiser");
}

TEST(ParseAuSet, RefusesWithTheColumn) {
  const auto message = [](std::string_view typed) {
    const auto frame = parse_au_set(typed);
    if (frame) return std::string("accepted");
    EXPECT_EQ(frame.error().kind, ErrorKind::Usage);
    return frame.error().message;
  };
  EXPECT_EQ(message("1,x"), "AU set '1,x', column 3: expected an AU number, L or R, found 'x'");
  EXPECT_EQ(message(" {1,x}"),
            "AU set ' {1,x}', column 5: expected an AU number, L or R, found 'x'");
  EXPECT_EQ(message(""), "AU set '', column 1: expected an AU number, L or R, found the end");
  EXPECT_EQ(message("{}"), "AU set '{}', column 2: expected an AU number, L or R, found the end");
  EXPECT_EQ(message("{1,6"),
            "AU set '{1,6', column 1: one brace is missing; write {1,6,12} or 1,6,12");
  EXPECT_EQ(message("~12"),
            "AU set '~12', column 1: changes only ('~') have a meaning in a stream; name the whole "
            "set");
  EXPECT_EQ(message("{12;40}"),
            "AU set '{12;40}', column 4: a time (';') has a meaning in a stream; name the AUs "
            "alone");
  EXPECT_EQ(message("12:101"), "AU set '12:101', column 6: an intensity is 0-100 percent");
  EXPECT_EQ(message("Inner Brow Raiser:500"),
            "AU set 'Inner Brow Raiser:500', column 21: an intensity is 0-100 percent")
      << "as it was typed, not with the number in the name's place";
  EXPECT_EQ(message("{ Left Wink:50, 12;40}"),
            "AU set '{ Left Wink:50, 12;40}', column 19: a time (';') has a meaning in a stream; "
            "name the AUs alone");
  EXPECT_EQ(message("{Wink"),
            "AU set '{Wink', column 1: one brace is missing; write {1,6,12} or "
            "1,6,12");
  EXPECT_EQ(message("1\n\x1b"),
            "AU set '1\\x0a\\x1b', column 3: expected ':', a letter of A-E x y "
            "z, ',', '+', ';' or the end, found '\\x1b'");
  EXPECT_EQ(message("{"), "AU set '{', column 1: one brace is missing; write {1,6,12} or 1,6,12");
}

}  // namespace
}  // namespace aucast::protocol
