#include "tests/unit/protocol/random_packets.h"

#include "protocol/limits.h"

namespace aucast::test {

using namespace protocol;

namespace {

std::string random_text(Seeded& seeded, std::string_view alphabet, int length_max) {
  std::string text;
  const int length = seeded.integer(1, length_max);
  for (int i = 0; i < length; ++i) {
    text += alphabet[static_cast<std::size_t>(
        seeded.integer(0, static_cast<int>(alphabet.size()) - 1))];
  }
  return text;
}

std::vector<AuTerm> random_changes(Seeded& seeded) {
  std::vector<AuTerm> terms;
  for (int number = 1; number <= kAuNumberMax; ++number) {
    if (!seeded.chance(0.1)) continue;
    const auto id = static_cast<std::uint8_t>(number);
    const auto percent = static_cast<std::uint8_t>(seeded.integer(0, 100));
    switch (seeded.integer(shows_on_one_side(number) ? 1 : 0, 2)) {
      case 0:
        terms.push_back({id, Side::Both, percent});
        break;
      case 1:
        terms.push_back({id, Side::Left, percent});
        break;
      default:
        terms.push_back({id, Side::Right, percent});
        break;
    }
  }
  return terms;
}

}  // namespace

Keyframe random_keyframe(Seeded& seeded) {
  Keyframe keyframe;
  keyframe.changes_only = seeded.chance(0.2);
  keyframe.terms = random_changes(seeded);
  if (!keyframe.changes_only) keyframe.terms = canonical_terms(frame_from_terms(keyframe.terms));
  if (seeded.chance(0.5)) {
    keyframe.time_ms = static_cast<std::uint32_t>(seeded.integer(0, kKeyframeTimeMsMax));
    if (seeded.chance(0.5)) {
      keyframe.place_ms = static_cast<std::uint64_t>(seeded.integer(0, 1'000'000)) * 1'000'000;
    }
  }
  return keyframe;
}

std::string random_stream_name(Seeded& seeded) {
  return random_text(seeded, "abcXYZ019._-", static_cast<int>(kStreamNameBytesMax));
}

HelloAsked random_hello(Seeded& seeded) {
  HelloAsked hello;
  hello.window = seeded.integer(0, kWindowMax);
  if (seeded.chance(0.5)) hello.stream = random_stream_name(seeded);
  if (seeded.chance(0.5)) hello.token = random_text(seeded, "ab1=!~\"'/\\", 100);
  hello.delta = seeded.chance(0.5);
  if (seeded.chance(0.5)) hello.voice = kVoiceCodec;
  hello.text = seeded.chance(0.5);
  hello.from_ms = seeded.chance(0.5) ? static_cast<std::uint64_t>(seeded.integer(0, 1 << 30)) : 0;
  return hello;
}

ServerPacket random_server_packet(Seeded& seeded) {
  switch (seeded.integer(0, 11)) {
    case 0:
      return End{};
    case 1: {
      HelloGranted hello;
      hello.window = seeded.integer(0, kWindowMax);
      hello.delta = seeded.chance(0.5);
      if (seeded.chance(0.5)) hello.stream = random_stream_name(seeded);
      hello.live = seeded.chance(0.5);
      if (seeded.chance(0.5))
        hello.duration_ms = static_cast<std::uint64_t>(seeded.integer(0, 1 << 30));
      hello.keyframe_ms = static_cast<std::uint32_t>(seeded.integer(1, kKeyframeTimeMsMax));
      if (seeded.chance(0.5)) hello.voice = kVoiceCodec;
      hello.text = seeded.chance(0.5);
      if (seeded.chance(0.5)) hello.title = random_text(seeded, "aB {}=", 20);
      return hello;
    }
    case 2:
      return ErrorReply{seeded.integer(100, 999), random_text(seeded, "a b'.=0", 200)};
    case 3: {
      StreamList list;
      const bool details = seeded.chance(0.5);
      for (int i = seeded.integer(0, 15); i > 0; --i) {
        ListedStream stream{random_stream_name(seeded)};
        if (details && seeded.chance(0.7)) stream.live = seeded.chance(0.5);
        if (details && seeded.chance(0.5))
          stream.duration_ms = static_cast<std::uint64_t>(seeded.integer(0, 1 << 30));
        if (details && seeded.chance(0.3)) stream.title = random_text(seeded, "aB {}=", 20);
        list.streams.push_back(std::move(stream));
      }
      return list;
    }
    case 4: {
      VoiceData voice{std::nullopt, "\x58" + random_text(seeded, {"\0\xff\x80{}az", 8}, 100)};
      if (seeded.chance(0.3))
        voice.place_ms = static_cast<std::uint64_t>(seeded.integer(0, 1 << 30));
      return voice;
    }
    case 5:
      return CaptionData{static_cast<std::uint64_t>(seeded.integer(0, 1 << 30)),
                         random_text(seeded, "ab {}\n", 80)};
    default:
      return random_keyframe(seeded);
  }
}

}  // namespace aucast::test
