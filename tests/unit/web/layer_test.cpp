#include "common/web/layer.h"

#include <gtest/gtest.h>

#include "tests/support/seeded.h"
#include "tests/support/web_frames.h"

namespace aucast::web {
namespace {

using test::client_frame;
using test::client_text;
using test::server_close;
using test::server_frame;
using test::server_text;

constexpr std::size_t kFrameBytesMax = 65536;

/// What one layer makes of some bytes.
struct Heard {
  std::string text;
  std::string answer;
  std::string reason;
};

Heard hear(std::string_view wire, std::size_t piece = std::string_view::npos) {
  Layer layer(kFrameBytesMax);
  Heard heard;
  while (!wire.empty()) {
    static_cast<void>(layer.received(wire.substr(0, piece), heard.text));
    wire.remove_prefix(std::min(piece, wire.size()));
  }
  heard.answer = layer.take_output();
  heard.reason = layer.reason();
  return heard;
}

/// A conversation with everything that is allowed in it.
std::string everything() {
  return client_text("{hello") + client_frame(0x01, " v=2") + client_frame(0x89, "still there?") +
         client_frame(0x00, " window=2") + client_frame(0x8a, "unasked") + client_frame(0x80, "}") +
         client_text("") + client_text(std::string(300, ' ')) +
         client_text(std::string(kFrameBytesMax, '1'));
}

TEST(WebChannel, ReadsTextCutIntoMessagesAndFragments) {
  const Heard heard = hear(everything());
  EXPECT_EQ(heard.reason, "");
  EXPECT_EQ(heard.text,
            "{hello v=2 window=2}" + std::string(300, ' ') + std::string(kFrameBytesMax, '1'));
  EXPECT_EQ(heard.answer, server_frame(0x8a, "still there?"));
}

TEST(WebChannel, ReadsTheSameHoweverTheWireIsCut) {
  const Heard whole = hear(everything());
  for (const std::size_t piece : {1U, 2U, 3U, 7U, 1000U}) {
    const Heard pieces = hear(everything(), piece);
    EXPECT_EQ(pieces.text, whole.text) << piece;
    EXPECT_EQ(pieces.answer, whole.answer) << piece;
  }
}

TEST(WebChannel, WritesTextInTheShortestFrame) {
  Layer layer(kFrameBytesMax);
  layer.send("{1}");
  EXPECT_EQ(layer.take_output(), server_text("{1}"));
  layer.send(std::string(125, 'x'));
  EXPECT_EQ(layer.take_output().substr(0, 2), "\x81\x7d");
  layer.send(std::string(126, 'x'));
  EXPECT_EQ(layer.take_output().substr(0, 4), std::string("\x81\x7e\x00\x7e", 4));
  layer.send(std::string(65536, 'x'));
  EXPECT_EQ(layer.take_output().substr(0, 10), std::string("\x81\x7f\0\0\0\0\0\x01\0\0", 10));
}

TEST(WebChannel, PingsAsItIsTold) {
  Layer layer(kFrameBytesMax);
  layer.ping();
  EXPECT_EQ(layer.take_output(), server_frame(0x89, ""));
  layer.end();
  layer.ping();
  EXPECT_EQ(layer.take_output(), server_close(1000));
}

TEST(WebChannel, OursIsTheFirstCloseOrAnswersThePeers) {
  Layer ours(kFrameBytesMax);
  ours.end();
  EXPECT_EQ(ours.take_output(), server_close(1000));
  ours.send("{1}");
  ours.end();
  EXPECT_EQ(ours.take_output(), "") << "nothing comes after a Close";

  Layer peers(kFrameBytesMax);
  std::string text;
  EXPECT_TRUE(
      peers.received(client_text("1") + client_frame(0x88, "\x0f\xa0 bye") + "noise", text));
  EXPECT_TRUE(peers.ended());
  EXPECT_EQ(text, "1");
  EXPECT_EQ(peers.take_output(), server_close(4000)) << "the same code";
  EXPECT_EQ(hear(client_frame(0x88, "")).answer, server_close(1000));
}

TEST(WebChannel, ClosesForWhatIsNotAllowed) {
  const std::string unmasked = server_text("1");
  const std::string close_of_one_byte = client_frame(0x88, "\x03");
  struct Case {
    std::string wire;
    int code;
    const char* reason;
  };
  const Case cases[] = {
      {unmasked, 1002, "a frame is not masked"},
      {client_frame(0xc1, "1"), 1002, "a frame uses an extension that was not agreed on"},
      {client_frame(0x82, "1"), 1003, "a binary message came; only text is spoken here"},
      {client_frame(0x02, "1"), 1003, "a binary message came; only text is spoken here"},
      {client_frame(0x83, "1"), 1002, "a frame has an unknown opcode"},
      {client_frame(0x8b, "1"), 1002, "a frame has an unknown opcode"},
      {client_frame(0x09, "1"), 1002, "a control frame is fragmented"},
      {client_frame(0x89, std::string(126, 'x')), 1002, "a control frame is longer than 125 bytes"},
      {client_frame(0x80, "1"), 1002, "a fragment belongs to no message"},
      {client_frame(0x01, "1") + client_text("1"), 1002, "a message begins within another"},
      {client_text("\xc3\xa4"), 1007, "a text message holds a byte beyond ASCII"},
      {client_text(std::string(kFrameBytesMax + 1, '1')), 1009,
       "a frame is longer than 65536 bytes"},
      {std::string("\x81\xff\0\0\0\0\x04\0\0\0", 10), 1009, "a frame is longer than 65536 bytes"},
      {std::string("\x81\xff\x80\0\0\0\0\0\0\0", 10), 1002,
       "a frame's length is not in its shortest form"},
      {std::string("\x81\xfe\0\x7d", 4), 1002, "a frame's length is not in its shortest form"},
      {std::string("\x81\xff\0\0\0\0\0\0\xff\xff", 10), 1002,
       "a frame's length is not in its shortest form"},
      {close_of_one_byte, 1002, "a Close has no proper code"},
      {client_frame(0x88, "\x03\xed"), 1002, "a Close has no proper code"},  // 1005
  };
  for (const Case& bad : cases) {
    for (const std::size_t piece : {std::string_view::npos, std::size_t{1}}) {
      const Heard heard = hear(bad.wire, piece);
      EXPECT_EQ(heard.reason, bad.reason);
      EXPECT_EQ(heard.answer, server_close(bad.code)) << bad.reason;
    }
  }
}

TEST(WebChannel, TextBeforeAFailureCounts) {
  const Heard heard = hear(client_text("11") + client_text("1\xff 1") + client_text("1"));
  EXPECT_EQ(heard.text, "111");
  EXPECT_EQ(heard.answer, server_close(1007));
}

TEST(WebChannel, NoiseIsTextOrAFailure) {
  test::Seeded random;
  SCOPED_TRACE(random.trace());
  const std::string good = everything().substr(0, 200);
  for (int round = 0; round < 5'000; ++round) {
    std::string wire = good;
    for (int change = random.integer(1, 4); change > 0; --change) {
      wire[static_cast<std::size_t>(random.integer(0, 199))] =
          static_cast<char>(random.integer(0, 255));
    }
    const Heard whole = hear(wire);
    const Heard pieces = hear(wire, static_cast<std::size_t>(random.integer(1, 9)));
    ASSERT_EQ(whole.text, pieces.text);
    ASSERT_EQ(whole.answer, pieces.answer);
    ASSERT_LE(whole.text.size(), wire.size());
  }
}

}  // namespace
}  // namespace aucast::web
