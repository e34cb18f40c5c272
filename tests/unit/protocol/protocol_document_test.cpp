// PROTOCOL.md is normative, so what it says is tested: its limits are those of limits.h, its
// examples are decoded, its conversations are played.

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "common/files.h"
#include "protocol/codec.h"
#include "protocol/decoder.h"
#include "protocol/limits.h"
#include "protocol/stream_file.h"
#include "server/settings/limits.h"
#include "tests/unit/protocol/transcript.h"

namespace aucast::protocol {
namespace {

std::string text_of_file(const std::string& name) {
  const auto text = read_file(AUCAST_PROTOCOL_FOLDER "/" + name);
  EXPECT_TRUE(text.has_value()) << text.error().message;
  return text ? *text : "";
}

std::string document() {
  return text_of_file("PROTOCOL.md");
}

/// The blocks fenced as ```KIND.
std::vector<std::string> blocks(const std::string& kind) {
  std::vector<std::string> found;
  std::istringstream text(document());
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (!inside && line == "```" + kind) {
      inside = true;
      found.emplace_back();
    } else if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      found.back() += line + '\n';
    }
  }
  return found;
}

std::vector<std::string> lines_of_blocks(const std::string& kind) {
  std::vector<std::string> lines;
  for (const std::string& block : blocks(kind)) {
    std::istringstream text(block);
    for (std::string line; std::getline(text, line);) lines.push_back(line);
  }
  return lines;
}

/// What a decoder makes of the bytes: canonical packets and the fault with its place.
template <typename Decoder>
std::string read_all(std::string_view bytes) {
  Decoder decoder;
  std::string text;
  while (const auto packet = decoder.next(bytes)) {
    text += (text.empty() ? "" : " ") +
            std::visit([](const auto& kind) { return encode(kind); }, *packet);
  }
  if (!decoder.error()) return text;
  return text + (text.empty() ? "" : " ") + "! " + std::string(name(decoder.error()->fault)) +
         " at " + std::to_string(decoder.error()->position);
}

template <typename Decoder>
void check_examples(const std::string& kind, std::size_t count_min) {
  const std::vector<std::string> lines = lines_of_blocks(kind);
  EXPECT_GE(lines.size(), count_min) << "the examples of " << kind << " are gone";
  for (const std::string& line : lines) {
    const std::size_t arrow = line.find(" => ");
    ASSERT_NE(arrow, std::string::npos) << line;
    const std::string written = line.substr(0, line.find_last_not_of(' ', arrow) + 1);
    EXPECT_EQ(read_all<Decoder>(test::unescaped(written)), line.substr(arrow + 4)) << line;
  }
}

TEST(ProtocolDocument, ExamplesOfPacketsAreTrue) {
  check_examples<ServerPacketDecoder>("server-examples", 20);
}

TEST(ProtocolDocument, ExamplesOfCodesAreTrue) {
  check_examples<ClientPacketDecoder>("client-examples", 8);
}

TEST(ProtocolDocument, TheStreamFileHoldsThePacketsBesideIt) {
  const std::vector<std::string> files = blocks("stream-file");
  ASSERT_EQ(files.size(), 1U);
  const auto stream = parse_stream_file(files.front(), "PROTOCOL.md");
  ASSERT_TRUE(stream.has_value()) << stream.error().message;
  std::vector<std::string> packets;
  for (const Keyframe& keyframe : stream->keyframes) packets.push_back(encode(keyframe));
  EXPECT_EQ(packets, lines_of_blocks("stream-packets"));
}

TEST(ProtocolDocument, ByteCountsOfTable55AreTrue) {
  std::vector<std::size_t> counts;
  for (const std::string& line : lines_of_blocks("byte-counts")) {
    std::istringstream words(line);
    std::string packet;
    std::size_t bytes = 0;
    words >> packet >> bytes;
    EXPECT_EQ(packet.size(), bytes) << line;
    EXPECT_EQ(read_all<ServerPacketDecoder>(packet), packet);
    counts.push_back(bytes);
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{19, 18, 13, 18, 11, 11}));
}

TEST(ProtocolDocument, ConversationsAreTrue) {
  const std::vector<std::string> conversations = blocks("transcript");
  EXPECT_GE(conversations.size(), 5U);
  for (const std::string& conversation : conversations) {
    if (test::is_for(conversation, "server")) {
      EXPECT_EQ(test::replay_on_server(conversation), "") << conversation;
    }
    if (test::is_for(conversation, "client")) {
      EXPECT_EQ(test::replay_on_client(conversation), "") << conversation;
    }
    if (conversation.find("\nroles turn\n") != std::string::npos) {
      EXPECT_EQ(test::replay_on_publisher(conversation), "") << conversation;
    }
  }
}

using Limits = std::map<std::string, std::int64_t>;

/// Those of server/settings/limits.h.
Limits server_limits() {
  return {
      {"kRelayedBytesMax", server::kRelayedBytesMax},
      {"kRelayedPerSecondMax", server::kRelayedPerSecondMax},
      {"kDialTimeMax", server::kDialTimeMax.count()},
      {"kRedialWaitFirst", server::kRedialWaitFirst.count()},
      {"kRedialWaitMax", server::kRedialWaitMax.count()},
      {"kNextHostWaitMax", server::kNextHostWaitMax.count()},
      {"kPublishAnswerTimeMax", server::kPublishAnswerTimeMax.count()},
      {"kOfferAgain", server::kOfferAgain.count()},
      {"kPushedStreamsMax", server::kPushedStreamsMax},
      {"kBatchBytesMax", server::kBatchBytesMax},
      {"kAcceptsInARow", server::kAcceptsInARow},
      {"kAcceptPause", server::kAcceptPause.count()},
      {"kRefusalsMax", server::kRefusalsMax},
      {"kDescriptorsKept", server::kDescriptorsKept},
      {"kClientLogLinesPerSecond", server::kClientLogLinesPerSecond},
      {"kHttpConnectionsMax", server::kHttpConnectionsMax},
      {"kHttpHeadBytesMax", server::kHttpHeadBytesMax},
      {"kHttpTimeMax", server::kHttpTimeMax.count()},
      {"kWebConnectionsMax", server::kWebConnectionsMax},
      {"kWebHeadBytesMax", server::kWebHeadBytesMax},
      {"kWebStallTimeMax", server::kWebStallTimeMax.count()},
  };
}

/// Those, and the ones of limits.h.
Limits all_limits() {
  Limits limits{
      {"kProtocolVersion", kProtocolVersion},
      {"kDefaultPort", kDefaultPort},
      {"kPacketBytesMax", kPacketBytesMax},
      {"kHelloBytesMax", kHelloBytesMax},
      {"kVoiceBytesMax", kVoiceBytesMax},
      {"kCaptionBytesMax", kCaptionBytesMax},
      {"kTitleBytesMax", kTitleBytesMax},
      {"kVoiceAheadMax", kVoiceAheadMax.count()},
      {"kBlankBytesMax", kBlankBytesMax},
      {"kEarlyAnswersMax", kEarlyAnswersMax},
      {"kSpareCodesMax", kSpareCodesMax},
      {"kSpareCodesPerSecond", kSpareCodesPerSecond},
      {"kSpareCodesPerPacket", kSpareCodesPerPacket},
      {"kTokenBytesMax", kTokenBytesMax},
      {"kServerIdBytesMax", kServerIdBytesMax},
      {"kRelayHopsMax", kRelayHopsMax},
      {"kStreamWaitMax", kStreamWaitMax.count()},
      {"kPublisherFileBytesMax", kPublisherFileBytesMax},
      {"kWrongTokenWait", kWrongTokenWait.count()},
      {"kWrongTokensTime", kWrongTokensTime.count()},
      {"kTlsHandshakeTimeMax", kTlsHandshakeTimeMax.count()},
      {"kStreamLineBytesMax", kStreamLineBytesMax},
      {"kStreamNameBytesMax", kStreamNameBytesMax},
      {"kWindowMax", kWindowMax},
      {"kKeyframeTimeMsMax", kKeyframeTimeMsMax},
      {"kPlaceMsMax", kPlaceMsMax},
      {"kNumberDigitsMax", kNumberDigitsMax},
      {"kDefaultKeyframeTime", kDefaultKeyframeTime.count()},
      {"kGraceMin", kGraceMin.count()},
      {"kGraceMax", kGraceMax.count()},
      {"kGraceRoundTrips", kGraceRoundTrips},
      {"kHelloTimeMax", kHelloTimeMax.count()},
      {"kDrainTimeMax", kDrainTimeMax.count()},
      {"kDrainBytesMax", kDrainBytesMax},
      {"kFullKeyframeEvery", kFullKeyframeEvery.count()},
      {"kLiveWindowTime", kLiveWindowTime.count()},
      {"kKeepAliveIdle", kKeepAliveIdle.count()},
      {"kKeepAliveInterval", kKeepAliveInterval.count()},
      {"kKeepAliveProbes", kKeepAliveProbes},
      {"kUnansweredTimeMax", kUnansweredTimeMax.count()},
      {"kReadBytesMax", kReadBytesMax},
      {"kOutputBytesMax", kOutputBytesMax},
      {"kWrongTokensMax", kWrongTokensMax},
      {"kGuessesMax", kGuessesMax},
      {"kLiveCaptionsMax", kLiveCaptionsMax},
      {"kWebFrameBytesMax", kWebFrameBytesMax},
      {"kWebPingIdle", kWebPingIdle.count()},
      {"kWebPongTimeMax", kWebPongTimeMax.count()},
      {"kOwedAnswersMax", kOwedAnswersMax},
      {"kFarewellTimeMax", kFarewellTimeMax.count()},
  };
  limits.merge(server_limits());
  return limits;
}

TEST(ProtocolDocument, LimitsAreThoseOfTheHeader) {
  const Limits limits = all_limits();
  Limits written;
  const std::regex row(R"(\| `(k\w+)` +\| ([0-9,]+))");
  const std::string text = document();
  for (std::sregex_iterator it(text.begin(), text.end(), row), end; it != end; ++it) {
    std::string value = (*it)[2];
    std::erase(value, ',');
    written[(*it)[1]] = std::stoll(value);
  }
  EXPECT_EQ(written, limits);

  const std::string header = text_of_file("limits.h") + text_of_file("../server/settings/limits.h");
  const std::regex declared(R"(inline constexpr (?:std::[\w:]+|int) (k\w+))");
  for (std::sregex_iterator it(header.begin(), header.end(), declared), end; it != end; ++it) {
    EXPECT_TRUE(limits.contains((*it)[1])) << (*it)[1] << " is missing in this test";
  }
}

TEST(ProtocolDocument, NamesEveryFault) {
  const std::string text = document();
  for (int fault = 0; fault <= static_cast<int>(DecodeFault::UnknownCode); ++fault) {
    const std::string word(name(static_cast<DecodeFault>(fault)));
    EXPECT_NE(text.find("| " + word), std::string::npos) << word;
  }
  for (const char* code : {"400", "401", "403", "404", "409", "503", "505", "508"}) {
    EXPECT_NE(text.find("| " + std::string(code) + " "), std::string::npos) << code;
  }
}

}  // namespace
}  // namespace aucast::protocol
