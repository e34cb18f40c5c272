#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/codec.h"
#include "protocol/decoder.h"
#include "protocol/limits.h"
#include "tests/support/seeded.h"
#include "tests/unit/protocol/random_packets.h"

namespace aucast::protocol {
namespace {

using test::Seeded;

std::string text_of(const ServerPacket& packet) {
  return std::visit([](const auto& kind) { return encode(kind); }, packet);
}

std::vector<ServerPacket> take_all(ServerPacketDecoder& decoder, std::string_view bytes) {
  std::vector<ServerPacket> packets;
  while (auto packet = decoder.next(bytes)) packets.push_back(std::move(*packet));
  EXPECT_TRUE(bytes.empty());
  return packets;
}

/// The canonical packets joined, then "!" and the fault, if there was one.
std::string decoded_server(std::string_view bytes) {
  ServerPacketDecoder decoder;
  std::string text;
  for (const ServerPacket& packet : take_all(decoder, bytes)) text += text_of(packet);
  if (decoder.error()) text += "!" + std::string(name(decoder.error()->fault));
  return text;
}

DecodeError server_error_of(std::string_view bytes) {
  ServerPacketDecoder decoder;
  static_cast<void>(take_all(decoder, bytes));
  return decoder.error().value_or(DecodeError{DecodeFault::IllegalByte, 9999, "no error"});
}

TEST(ServerPacketDecoder, ReadsEveryKindOfPacket) {
  EXPECT_EQ(decoded_server("{1,6,12,14}{0}{-2}"), "{1,6,12,14}{0}{-2}");
  EXPECT_EQ(decoded_server("{1:30,R12:80;40@73400}{~;33}"), "{1:30,R12:80;40@73400}{~;33}");
  EXPECT_EQ(decoded_server("{hello v=2 window=64 stream=talk keyframe=40}"),
            "{hello v=2 window=64 stream=talk keyframe=40}");
  EXPECT_EQ(decoded_server("{hello}"), "{hello v=2 window=1 keyframe=250}");
  EXPECT_EQ(decoded_server("{hello  v=2 future=x window=3 window=4}"),
            "{hello v=2 window=4 keyframe=250}");
  EXPECT_EQ(decoded_server("{error 404 no such stream}"), "{error 404 no such stream}");
  EXPECT_EQ(decoded_server("{error 503}"), "{error 503 }");
  EXPECT_EQ(decoded_server("{streams a b}{streams}"), "{streams a b}{streams}");
  EXPECT_EQ(decoded_server("{streams stream=a live=1  duration=7 stream=b title=QQ}"),
            "{streams stream=a live=1 duration=7 stream=b title=QQ}");
  EXPECT_EQ(decoded_server("{streams stream=a stream=b}"), "{streams a b}");
  EXPECT_EQ(decoded_server("{streams stream=a live=0 colour=red live=1}"),
            "{streams stream=a live=1}")
      << "the last value counts, and what is not known is ignored";
  EXPECT_EQ(decoded_server("{streams count=1 live=1 stream=a}"), "{streams a}")
      << "before the first name it is said of the list";
  EXPECT_EQ(decoded_server("{streams stream=live stream=duration live=1}"),
            "{streams stream=live stream=duration live=1}")
      << "names as keys are";
}

TEST(ServerPacketDecoder, AcceptsBlanksBetweenPacketsAndAroundNumbers) {
  EXPECT_EQ(decoded_server(" \r\n{ 1 ,\r\n6 }\n{ -2 }\n"), "{1,6}{-2}");
  EXPECT_EQ(decoded_server("{ L 12 C ; 40 @ 0 }"), "{L12:50;40@0}");
}

TEST(ServerPacketDecoder, NamesEachFaultAndItsPlace) {
  struct Row {
    std::string_view bytes;
    DecodeFault fault;
    std::uint64_t position;
  };
  const Row rows[] = {
      {"x", DecodeFault::IllegalByte, 0},
      {"{1}}", DecodeFault::IllegalByte, 3},
      {"{1}{2x3", DecodeFault::IllegalByte, 6},
      {"{}", DecodeFault::IllegalByte, 1},
      {"{ }", DecodeFault::IllegalByte, 2},
      {"{1,}", DecodeFault::IllegalByte, 3},
      {"{1\t}", DecodeFault::IllegalByte, 2},
      {"{1+2}", DecodeFault::IllegalByte, 2},
      {"{{", DecodeFault::IllegalByte, 1},
      {"{ hello}", DecodeFault::IllegalByte, 2},
      {"{- 2}", DecodeFault::IllegalByte, 2},
      {"{-2x}", DecodeFault::IllegalByte, 3},
      {"{-}", DecodeFault::IllegalByte, 2},
      {"{100}", DecodeFault::NumberTooBig, 3},
      {"{001}", DecodeFault::NumberTooBig, 3},
      {"{1:101}", DecodeFault::NumberTooBig, 5},
      {"{1:0100}", DecodeFault::NumberTooBig, 6},
      {"{1;3600001}", DecodeFault::NumberTooBig, 9},
      {"{1;1@1000000000001}", DecodeFault::NumberTooBig, 17},
      {"{-3}", DecodeFault::UnknownPacket, 2},
      {"{-22}", DecodeFault::UnknownPacket, 3},
      {"{-2 1}", DecodeFault::UnknownPacket, 4},
      {"{hallo}", DecodeFault::UnknownPacket, 2},
      {"{hell}", DecodeFault::UnknownPacket, 5},
      {"{hello=1}", DecodeFault::UnknownPacket, 6},
      {"{x}", DecodeFault::UnknownPacket, 1},
      {"{hello v=2\n}", DecodeFault::IllegalByte, 10},
      {"{hello v=2{}", DecodeFault::IllegalByte, 10},
      {"{hello window=300}", DecodeFault::BadField, 14},
      {"{hello window=}", DecodeFault::BadField, 14},
      {"{hello window}", DecodeFault::BadField, 7},
      {"{hello =3}", DecodeFault::BadField, 7},
      {"{hello v=x window=1}", DecodeFault::BadField, 9},
      {"{hello v=x window}", DecodeFault::BadField, 11},  // the form of all comes first
      {"{hello live=2}", DecodeFault::BadField, 12},
      {"{hello stream=a/b}", DecodeFault::BadField, 14},
      {"{1}{hello keyframe=9999999999999999999999}", DecodeFault::BadField, 19},
      {"{error}", DecodeFault::BadField, 6},
      {"{error 40 x}", DecodeFault::BadField, 7},
      {"{error 4x4 x}", DecodeFault::BadField, 7},
      {"{error 044 x}", DecodeFault::BadField, 7},
      {"{hello title=}", DecodeFault::BadField, 13},
      {"{streams a/b}", DecodeFault::BadField, 9},
      {"{streams a live=1}", DecodeFault::BadField, 11},
      {"{streams stream=a b}", DecodeFault::BadField, 18},
      {"{streams stream=a/b}", DecodeFault::BadField, 16},
      {"{streams stream=}", DecodeFault::BadField, 16},
      {"{streams =a}", DecodeFault::BadField, 9},
      {"{streams stream=a live=2}", DecodeFault::BadField, 23},
      {"{streams stream=a live=}", DecodeFault::BadField, 23},
      {"{streams stream=a live=1 live=x}", DecodeFault::BadField, 30},
      {"{streams stream=a duration=1000000000001}", DecodeFault::BadField, 27},
      {"{streams stream=a title=gA}", DecodeFault::BadField, 24},
      {"{streams stream=a title=}", DecodeFault::BadField, 24},
  };
  for (const Row& row : rows) {
    const DecodeError error = server_error_of(row.bytes);
    EXPECT_EQ(name(error.fault), name(row.fault)) << row.bytes << ": " << error.reason;
    EXPECT_EQ(error.position, row.position) << row.bytes << ": " << error.reason;
  }
}

TEST(ServerPacketDecoder, SaysWhyInASentenceWithPeerBytesEscaped) {
  EXPECT_EQ(server_error_of("\x1b").reason, "expected '{', found '\\x1b'");
  EXPECT_EQ(server_error_of("{-3}").reason, "of the negative packets only {-2} exists");
  EXPECT_EQ(server_error_of("{hi").reason, "the word beginning 'hi' is none of the protocol's");
  EXPECT_EQ(server_error_of("{hello window=300}").reason,
            "window is a number of 0-256, found '300'");
  EXPECT_EQ(server_error_of("{error no}").reason, "an error has a code of 100-999, found 'no'");
  EXPECT_EQ(server_error_of("{streams a/b}").reason, "'a/b' is no stream's name");
  EXPECT_EQ(server_error_of("{streams stream=a live=2}").reason,
            "live is a number of 0-1, found '2'");
}

TEST(ServerPacketDecoder, FindsTheFaultBeforeAnyClosingBrace) {
  ServerPacketDecoder decoder;
  EXPECT_TRUE(take_all(decoder, "{1,").empty());
  EXPECT_FALSE(decoder.error().has_value());
  EXPECT_TRUE(take_all(decoder, "?").empty());
  ASSERT_TRUE(decoder.error().has_value());
  EXPECT_EQ(decoder.error()->position, 3U);
}

TEST(ServerPacketDecoder, HoldsAPacketToItsLimit) {
  std::string longest = "{1";
  longest.append(kPacketBytesMax - longest.size() - 1, ' ');
  EXPECT_EQ(decoded_server(longest + "}"), "{1}");
  const DecodeError error = server_error_of(longest + " }");
  EXPECT_EQ(error.fault, DecodeFault::PacketTooLong);
  EXPECT_EQ(error.position, kPacketBytesMax - 0U);
  EXPECT_EQ(error.reason, "no closing brace within 4096 bytes");

  std::string hello = "{hello ";
  hello.append(kHelloBytesMax - hello.size() - 1, ' ');
  EXPECT_EQ(decoded_server(hello + "}"), "{hello v=2 window=1 keyframe=250}");
  EXPECT_EQ(server_error_of(hello + " }").fault, DecodeFault::PacketTooLong);
  EXPECT_EQ(server_error_of(hello + " }").position, kHelloBytesMax - 0U);
}

TEST(ServerPacketDecoder, HoldsBlanksToTheirLimitPerGap) {
  const std::string blanks(kBlankBytesMax, '\n');
  EXPECT_EQ(decoded_server(blanks + "{1}" + blanks + "{2}" + blanks), "{1}{2}");
  EXPECT_EQ(server_error_of(blanks + " {1}").fault, DecodeFault::TooManyBlanks);
  EXPECT_EQ(server_error_of(blanks + " {1}").position, kBlankBytesMax);
}

TEST(ServerPacketDecoder, TenMegabytesWithoutABraceStopAtTheLimit) {
  ServerPacketDecoder decoder;
  take_all(decoder, "{");
  const std::string flood(1U << 20U, ' ');
  for (int i = 0; i < 10; ++i) take_all(decoder, flood);
  ASSERT_TRUE(decoder.error().has_value());
  EXPECT_EQ(decoder.error()->fault, DecodeFault::PacketTooLong);
  EXPECT_LE(decoder.error()->position, kPacketBytesMax + 1);
}

TEST(ServerPacketDecoder, DeliversWhatWasCompleteBeforeTheFaultAndThenNothing) {
  ServerPacketDecoder decoder;
  EXPECT_EQ(take_all(decoder, "{1}{2}x{3}").size(), 2U);
  const auto first = decoder.error();
  ASSERT_TRUE(first.has_value());
  EXPECT_TRUE(take_all(decoder, "{4}").empty());
  EXPECT_EQ(decoder.error(), first) << "sticky";
  EXPECT_FALSE(decoder.mid_packet());
}

TEST(ServerPacketDecoder, KnowsWhereItIs) {
  ServerPacketDecoder decoder;
  EXPECT_FALSE(decoder.mid_packet());
  EXPECT_TRUE(take_all(decoder, "{1, ").empty());
  EXPECT_TRUE(decoder.mid_packet());
  EXPECT_EQ(take_all(decoder, "6}\n").size(), 1U);
  EXPECT_FALSE(decoder.mid_packet());
  EXPECT_EQ(decoder.taken_bytes(), 6U);
}

TEST(ServerPacketDecoder, ReadsNoFurtherThanThePacketItGives) {
  ServerPacketDecoder decoder;
  std::string_view bytes = "{1}{2?}";
  EXPECT_TRUE(decoder.next(bytes).has_value());
  EXPECT_EQ(bytes, "{2?}");
  EXPECT_FALSE(decoder.error().has_value()) << "the fault behind it has not been met";
  EXPECT_FALSE(decoder.next(bytes).has_value());
  EXPECT_TRUE(decoder.error().has_value());
}

TEST(ServerPacketDecoder, RoundTripsRandomPackets) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 2000; ++run) {
    const ServerPacket packet = test::random_server_packet(seeded);
    const std::string bytes = text_of(packet);
    ServerPacketDecoder decoder;
    const auto packets = take_all(decoder, bytes);
    ASSERT_FALSE(decoder.error().has_value()) << bytes << ": " << decoder.error()->reason;
    ASSERT_EQ(packets.size(), 1U) << bytes;
    EXPECT_EQ(packets.front(), packet) << bytes;
  }
}

TEST(ServerPacketDecoder, GivesTheSameForBytesCutAnywhere) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::string bytes;
  std::vector<ServerPacket> sent;
  for (int i = 0; i < 40; ++i) {
    sent.push_back(test::random_server_packet(seeded));
    bytes += text_of(sent.back()) + (seeded.chance(0.3) ? " \r\n" : "");
  }
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    ServerPacketDecoder decoder;
    auto got = take_all(decoder, std::string_view(bytes).substr(0, cut));
    for (auto& packet : take_all(decoder, std::string_view(bytes).substr(cut))) {
      got.push_back(std::move(packet));
    }
    ASSERT_EQ(got, sent) << "cut at " << cut;
  }
  for (int run = 0; run < 200; ++run) {
    ServerPacketDecoder decoder;
    std::vector<ServerPacket> got;
    for (std::string_view rest = bytes; !rest.empty();) {
      const auto portion = static_cast<std::size_t>(seeded.integer(1, 30));
      for (auto& packet : take_all(decoder, rest.substr(0, portion))) {
        got.push_back(std::move(packet));
      }
      rest.remove_prefix(std::min(portion, rest.size()));
    }
    ASSERT_EQ(got, sent);
  }
}

TEST(ServerPacketDecoder, AFlippedBitIsAnErrorOrALegalPacket) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 5000; ++run) {
    std::string bytes = text_of(test::random_server_packet(seeded)) + "{-2}";
    const auto place =
        static_cast<std::size_t>(seeded.integer(0, static_cast<int>(bytes.size()) - 1));
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << seeded.integer(0, 7)));
    ServerPacketDecoder whole;
    for (const ServerPacket& packet : take_all(whole, bytes)) {
      EXPECT_EQ(decoded_server(text_of(packet)), text_of(packet)) << "what was accepted is legal";
    }
    ServerPacketDecoder bytewise;
    for (const char byte : bytes) take_all(bytewise, std::string_view(&byte, 1));
    EXPECT_EQ(bytewise.error(), whole.error()) << bytes;
  }
}

}  // namespace
}  // namespace aucast::protocol
