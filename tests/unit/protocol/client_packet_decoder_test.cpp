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

std::string text_of(const ClientPacket& packet) {
  return std::visit([](const auto& kind) { return encode(kind); }, packet);
}

std::vector<ClientPacket> take_all(ClientPacketDecoder& decoder, std::string_view bytes) {
  std::vector<ClientPacket> packets;
  while (auto packet = decoder.next(bytes)) packets.push_back(std::move(*packet));
  EXPECT_TRUE(bytes.empty());
  return packets;
}

std::string decoded(std::string_view bytes) {
  ClientPacketDecoder decoder;
  std::string text;
  for (const ClientPacket& packet : take_all(decoder, bytes)) {
    text += (text.empty() ? "" : " ") + text_of(packet);
  }
  if (decoder.error()) text += "!" + std::string(name(decoder.error()->fault));
  return text;
}

DecodeError error_of(std::string_view bytes) {
  ClientPacketDecoder decoder;
  static_cast<void>(take_all(decoder, bytes));
  return decoder.error().value_or(DecodeError{DecodeFault::IllegalByte, 9999, "no error"});
}

TEST(ClientPacketDecoder, CompletesACodeAtItsDigit) {
  EXPECT_EQ(decoded("1"), "1");
  EXPECT_EQ(decoded("11-1-31-4"), "1 1 -1 -3 1 -4");
  EXPECT_EQ(decoded(" 1\r\n1 \n-1\n"), "1 1 -1");
  ClientPacketDecoder decoder;
  EXPECT_TRUE(take_all(decoder, "-").empty());
  EXPECT_TRUE(decoder.mid_packet());
  EXPECT_EQ(take_all(decoder, "3"), std::vector<ClientPacket>{Code::Resume});
  EXPECT_FALSE(decoder.mid_packet());
}

TEST(ClientPacketDecoder, TakesAHelloOrStreamsBeforeTheFirstCode) {
  EXPECT_EQ(decoded("{hello v=2 window=64}1"), "{hello v=2 window=64} 1");
  EXPECT_EQ(decoded("\r\n {hello}"), "{hello v=2 window=1}");
  EXPECT_EQ(decoded("{streams}"), "{streams}");
  EXPECT_EQ(decoded("{streams details=1}"), "{streams details=1}");
  EXPECT_EQ(decoded("{streams details=0 token=a}"), "{streams token=a}");
  EXPECT_EQ(decoded("{hello v=2 colour=green window=7}"), "{hello v=2 window=7}")
      << "unknown keys are ignored";
  EXPECT_EQ(decoded("{hello window=999999}"), "{hello v=2 window=999999}")
      << "the server grants what it likes";
}

TEST(ClientPacketDecoder, LeavesTheFieldsOfAnotherVersionAlone) {
  EXPECT_EQ(decoded("{hello window=many v=3}"), "{hello v=3 window=1}");
}

TEST(ClientPacketDecoder, NamesEachFaultAndItsPlace) {
  struct Row {
    std::string_view bytes;
    DecodeFault fault;
    std::uint64_t position;
  };
  const Row rows[] = {
      {"0", DecodeFault::UnknownCode, 0},
      {"12", DecodeFault::UnknownCode, 1},
      {"-2", DecodeFault::UnknownCode, 1},
      {"- 1", DecodeFault::UnknownCode, 1},
      {"1\t1", DecodeFault::UnknownCode, 1},
      {"GET / HTTP/1.1", DecodeFault::UnknownCode, 0},
      {"1{hello}", DecodeFault::UnknownCode, 1},
      {"{hello}{hello}", DecodeFault::UnknownCode, 7},
      {"{1,6}", DecodeFault::UnknownPacket, 1},
      {"{error 404 x}", DecodeFault::UnknownPacket, 1},
      {"{}", DecodeFault::UnknownPacket, 1},
      {"{hello v=2\r\n}", DecodeFault::IllegalByte, 10},
      {"{hello window=-1}", DecodeFault::BadField, 14},
      {"{hello window=1000000}", DecodeFault::BadField, 14},
      {"{hello stream=../x}", DecodeFault::BadField, 14},
      {"{hello stream=}", DecodeFault::BadField, 14},
      {"{hello delta=yes}", DecodeFault::BadField, 13},
      {"{hello from=x}", DecodeFault::BadField, 12},
      {"{hello v=}", DecodeFault::BadField, 9},
      {"{hello nonsense}", DecodeFault::BadField, 7},
      {"{streams all}", DecodeFault::BadField, 9},
      {"{streams details=2}", DecodeFault::BadField, 17},
      {"{streams details}", DecodeFault::BadField, 9},
  };
  for (const Row& row : rows) {
    const DecodeError error = error_of(row.bytes);
    EXPECT_EQ(name(error.fault), name(row.fault)) << row.bytes << ": " << error.reason;
    EXPECT_EQ(error.position, row.position) << row.bytes << ": " << error.reason;
  }
  EXPECT_EQ(error_of("\x1b").reason, "'\\x1b' is no control code; those are 1, -1, -3 and -4");
  EXPECT_EQ(error_of("-2").reason, "'-2' is no control code; those are 1, -1, -3 and -4");
  EXPECT_EQ(error_of("{streams all}").reason, "expected key=value, found 'all'");
}

TEST(ClientPacketDecoder, HoldsHelloAndBlanksToTheirLimits) {
  std::string hello = "{hello unknown=";
  hello.append(kHelloBytesMax - hello.size() - 1, 'x');
  EXPECT_EQ(decoded(hello + "}"), "{hello v=2 window=1}");
  EXPECT_EQ(error_of(hello + "x}").fault, DecodeFault::PacketTooLong);
  EXPECT_EQ(error_of(hello + "x}").position, kHelloBytesMax - 0U);
  const std::string blanks(kBlankBytesMax, '\n');
  EXPECT_EQ(decoded(blanks + "1" + blanks + "1"), "1 1");
  EXPECT_EQ(error_of("1" + blanks + " 1").fault, DecodeFault::TooManyBlanks);
}

TEST(ClientPacketDecoder, RefusesATokenThatIsTooLongAndDoesNotRepeatIt) {
  const std::string longest(kTokenBytesMax, 'x');
  EXPECT_EQ(decoded("{hello token=" + longest + "}"), "{hello v=2 window=1 token=" + longest + "}");
  EXPECT_EQ(decoded("{streams token=" + longest + "}"), "{streams token=" + longest + "}");
  for (const std::string word : {"{hello token=", "{streams token="}) {
    const DecodeError error = error_of(word + longest + "x}");
    EXPECT_EQ(name(error.fault), "bad field");
    EXPECT_EQ(error.position, word.size());
    EXPECT_EQ(error.reason, "token is longer than 256 bytes");
  }
}

TEST(ClientPacketDecoder, TakesTheLastOfARepeatedKeyAndNamesTheFirstBadValue) {
  EXPECT_EQ(decoded("{hello window=3 stream=a window=4 stream=b}"),
            "{hello v=2 window=4 stream=b}");
  EXPECT_EQ(decoded("{hello token=a token=}"), "{hello v=2 window=1}") << "an empty token is none";
  EXPECT_EQ(error_of("{hello window=x window=4}").position, 14U);
  EXPECT_EQ(error_of("{hello from=x window=y}").position, 12U);
  EXPECT_EQ(error_of("{hello window=x nonsense v=y}").position, 16U) << "the form comes first";
  EXPECT_EQ(error_of("{hello window=x v=y}").position, 18U) << "then the version";
}

TEST(ClientPacketDecoder, ReadsNumbersOfAHelloOfUpToThirteenDigits) {
  EXPECT_EQ(decoded("{hello window=0000000000007 v=0002}"), "{hello v=2 window=7}");
  EXPECT_EQ(error_of("{hello window=00000000000007}").fault, DecodeFault::BadField);
  EXPECT_EQ(decoded("{hello v=999999}"), "{hello v=999999 window=1}");
  EXPECT_EQ(error_of("{hello v=1000000}").fault, DecodeFault::BadField);
}

TEST(ClientPacketDecoder, IsStickyAndDeliversWhatCameBefore) {
  ClientPacketDecoder decoder;
  EXPECT_EQ(take_all(decoder, "11x1").size(), 2U);
  EXPECT_TRUE(take_all(decoder, "1").empty());
  EXPECT_EQ(decoder.error()->position, 2U);
  EXPECT_FALSE(decoder.mid_packet());
}

TEST(ClientPacketDecoder, RoundTripsRandomHellosAndGivesTheSameForBytesCutAnywhere) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 300; ++run) {
    std::vector<ClientPacket> sent{test::random_hello(seeded)};
    const Code codes[] = {Code::Received, Code::Pause, Code::Resume, Code::Stop};
    for (int i = 0; i < 10; ++i) sent.push_back(codes[seeded.integer(0, 3)]);
    std::string bytes;
    for (const ClientPacket& packet : sent)
      bytes += text_of(packet) + (seeded.chance(0.3) ? "\n" : "");
    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
      ClientPacketDecoder decoder;
      auto got = take_all(decoder, std::string_view(bytes).substr(0, cut));
      for (auto& packet : take_all(decoder, std::string_view(bytes).substr(cut))) {
        got.push_back(std::move(packet));
      }
      ASSERT_EQ(got, sent) << bytes << " cut at " << cut;
    }
  }
}

TEST(ClientPacketDecoder, AFlippedBitIsAnErrorOrALegalPacket) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 5000; ++run) {
    std::string bytes = encode(test::random_hello(seeded)) + "11-1-31-4";
    const auto place =
        static_cast<std::size_t>(seeded.integer(0, static_cast<int>(bytes.size()) - 1));
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << seeded.integer(0, 7)));
    ClientPacketDecoder whole;
    for (const ClientPacket& packet : take_all(whole, bytes)) {
      EXPECT_EQ(decoded(text_of(packet)), text_of(packet));
    }
    ClientPacketDecoder bytewise;
    for (const char byte : bytes) take_all(bytewise, std::string_view(&byte, 1));
    EXPECT_EQ(bytewise.error(), whole.error()) << bytes;
  }
}

}  // namespace
}  // namespace aucast::protocol
