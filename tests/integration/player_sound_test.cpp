// The real face-player with a voice: videos by the video clock, and a device that nobody hears.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/voice/voice_encoder.h"
#include "protocol/codec.h"
#include "tests/integration/player_run.h"
#include "tests/support/scripted_server.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::test {
namespace {

constexpr int kSeconds = 3;

/// Whose times keyframes have.
enum class Times : std::uint8_t { Own, Server };

/// A server that sends three seconds of voice, and a keyframe for each 100 ms of it.
/// Mute, it sends the keyframes only.
class TalkingServer {
 public:
  explicit TalkingServer(Times times, bool mute = false)
      : server_({Accept{}, ExpectHello{}, Send{talk(packets_, times, mute)}, ExpectEnd{}}) {}
  explicit TalkingServer(bool mute = false) : TalkingServer(Times::Own, mute) {}

  [[nodiscard]] std::string address() const {
    return "127.0.0.1:" + std::to_string(server_.port());
  }
  [[nodiscard]] std::size_t packets() const { return packets_; }
  [[nodiscard]] std::string received() const { return server_.received(); }

 private:
  static std::string talk(std::size_t& count, Times times, bool mute) {
    voice::VoiceEncoder encoder({});
    std::vector<protocol::VoicePacket> packets;
    encoder.add(voice::test::speech_like(kSeconds), packets);
    encoder.finish(packets);
    if (mute) packets.clear();
    count = packets.size();
    std::string bytes = "{hello v=2 window=64 keyframe=100";
    bytes += mute ? "}" : " voice=opus}";
    std::size_t next = 0;
    for (int end_ms = 100; end_ms <= 1000 * kSeconds; end_ms += 100) {
      for (; next < packets.size() && packets[next].place.count() < end_ms; ++next) {
        const auto place = static_cast<std::uint64_t>(packets[next].place.count());
        bytes += protocol::encode(protocol::VoiceData{place, packets[next].opus});
      }
      bytes += end_ms % 200 == 0 ? "{26:50" : "{26:0";
      bytes += times == Times::Own ? ";100}" : "}";
    }
    return bytes + "{-2}";
  }

  std::size_t packets_ = 0;
  ScriptedServer server_;
};

/// The samples of a WAV file with a header of 44 bytes.
std::vector<float> samples_of(const std::string& wav) {
  std::vector<float> samples;
  for (std::size_t at = 44; at + 1 < wav.size(); at += 2) {
    const auto low = static_cast<unsigned char>(wav[at]);
    const auto high = static_cast<signed char>(wav[at + 1]);
    samples.push_back(static_cast<float>(high * 256 + low) / 32768);
  }
  return samples;
}

TEST(PlayerSound, WritesTheVoiceThatComesWhereItBelongs) {
  const TempFolder folder;
  TalkingServer server;
  const PlayerRun run =
      run_player({"--headless", server.address(), "--sound", (folder.path() / "a.wav").string()});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_NE(server.received().find("voice=opus"), std::string::npos);
  EXPECT_EQ(run.stats["voice_packets"], server.packets());
  EXPECT_EQ(run.stats["voice_late"], 0);
  std::vector<float> heard;
  const auto samples = samples_of(folder.read("a.wav"));
  EXPECT_GE(samples.size(), std::size_t{48000} * kSeconds);
  for (std::size_t i = 0; i < samples.size(); i += 3) heard.push_back(samples[i]);
  const auto source = voice::test::speech_like(kSeconds);
  int best = -100;
  for (int lag = -100; lag <= 100; ++lag) {
    const double better = voice::test::correlation(source, heard, lag);
    if (better > voice::test::correlation(source, heard, best)) best = lag;
  }
  EXPECT_LE(std::abs(best), 2) << "samples of 1/16 ms";
}

TEST(PlayerSound, TheSameStreamMakesTheSameSound) {
  const TempFolder folder;
  for (const char* name : {"a.wav", "b.wav"}) {
    TalkingServer server;
    const PlayerRun run =
        run_player({"--headless", server.address(), "--sound", (folder.path() / name).string()});
    ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  }
  EXPECT_EQ(folder.read("a.wav"), folder.read("b.wav"));
}

TEST(PlayerSound, AtAnotherSpeedTheSoundIsHeardOnceAndInStep) {
  const TempFolder folder;
  TalkingServer server(Times::Server);
  const PlayerRun run = run_player({"--headless", server.address(), "--speed", "125", "--sound",
                                    (folder.path() / "a.wav").string()});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  const auto samples = samples_of(folder.read("a.wav"));
  EXPECT_NEAR(static_cast<double>(samples.size()) / 48000, 1.25 * kSeconds, 0.1);
  std::vector<float> heard;
  for (double at = 0; at < static_cast<double>(samples.size()); at += 3 * 1.25) {
    heard.push_back(samples[static_cast<std::size_t>(at)]);
  }
  EXPECT_GT(voice::test::correlation(voice::test::speech_like(kSeconds), heard, 0), 0.7);
}

TEST(PlayerSound, ADeviceIsTheClockAndFaceAndSoundAreTogether) {
  TalkingServer server;
  const PlayerRun run = run_player({"--headless", server.address(), "--sound-device", "default"},
                                   {"ALSOFT_DRIVERS=null"});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["voice_packets"], server.packets());
  EXPECT_EQ(run.stats["keyframes_played"], 10 * kSeconds);
  ASSERT_TRUE(run.stats["face_to_sound_p50_ms"].is_number()) << run.stats;
  EXPECT_LT(std::abs(run.stats["face_to_sound_p50_ms"].get<double>()), 45);
}

/// Whose voice is heard 31 years after the face.
std::string far_voice() {
  return "{hello v=2 window=64 voice=opus}{a@1000000000000 SGhp}{a SGhp}{1;100}{2;100}{-2}";
}

TEST(PlayerSound, VoiceLongAfterTheFaceIsLeftOut) {
  const TempFolder folder;
  const std::string wav = (folder.path() / "a.wav").string();
  const std::vector<std::vector<std::string>> ways{{"--sound", wav}, {"--sound-device", "default"}};
  for (const auto& way : ways) {
    ScriptedServer server({Accept{}, ExpectHello{}, Send{far_voice()}, ExpectEnd{}});
    std::vector<std::string> arguments{"--headless", "127.0.0.1:" + std::to_string(server.port())};
    arguments.insert(arguments.end(), way.begin(), way.end());
    const PlayerRun run = run_player(arguments, {"ALSOFT_DRIVERS=null"});
    ASSERT_EQ(run.finished.exit_code, 0) << way[0] << run.finished.err;
    EXPECT_EQ(run.stats["voice_left_out"], 2) << way[0];
  }
  EXPECT_EQ(samples_of(folder.read("a.wav")).size(), 48U * 200);
}

TEST(PlayerSound, WithoutADeviceNoVoiceIsAskedForAndTheFacePlays) {
  TalkingServer server(true);
  const PlayerRun run =
      run_player({"--headless", server.address(), "--sound-device", "no such device"},
                 {"ALSOFT_DRIVERS=null"});
  EXPECT_EQ(run.finished.exit_code, 0);
  EXPECT_EQ(server.received().find("voice"), std::string::npos);
  EXPECT_NE(run.finished.err.find("no such device"), std::string::npos) << run.finished.err;
  EXPECT_EQ(run.stats["keyframes_played"], 10 * kSeconds);
}

TEST(PlayerSound, AComputerWithoutSoundIsOneLineOfTheLog) {
  TalkingServer server(true);
  const PlayerRun run = run_player({"--headless", server.address(), "--sound-device", "default"},
                                   {"ALSOFT_DRIVERS=alsa", "ALSA_CONFIG_PATH=/dev/null"});
  EXPECT_EQ(run.finished.exit_code, 0);
  EXPECT_NE(run.finished.err.find("without sound: "), std::string::npos) << run.finished.err;
  EXPECT_EQ(std::count(run.finished.err.begin(), run.finished.err.end(), '\n'), 1)
      << run.finished.err;
}

TEST(PlayerSound, ASoundFileBesideAStreamFileIsItsSound) {
  const TempFolder folder;
  const auto stream = folder.write("talk.txt", "Beg_Stream\n26:50;500\n26:0;500\nEnd_Stream\n");
  const std::string silence = (folder.path() / "silence.wav").string();
  ASSERT_EQ(
      run_player({"play", stream.string(), "--headless", "--sound", silence}).finished.exit_code,
      0);
  EXPECT_EQ(samples_of(folder.read("silence.wav")), std::vector<float>(48000));
  std::filesystem::rename(silence, folder.path() / "talk.wav");
  const std::string written = (folder.path() / "a.wav").string();
  const PlayerRun run = run_player({"play", stream.string(), "--headless", "--sound", written});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(folder.read("a.wav").size(), folder.read("talk.wav").size());
}

}  // namespace
}  // namespace aucast::test
