#include "client/app/player_options.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

using Arguments = std::vector<std::string>;

PlayerOptions accepted(Arguments arguments) {
  auto options = parse_player_options(std::move(arguments));
  EXPECT_TRUE(options.has_value()) << (options ? "" : options.error().message);
  return options ? *options : PlayerOptions{};
}

std::string refused(Arguments arguments) {
  const auto options = parse_player_options(std::move(arguments));
  EXPECT_FALSE(options.has_value());
  if (options) return "";
  EXPECT_EQ(options.error().kind, ErrorKind::Usage);
  EXPECT_EQ(options.error().message.find('\n'), std::string::npos);
  return options.error().message;
}

TEST(PlayerOptions, DefaultsAreTheDocumentedOnes) {
  const PlayerOptions options = accepted({"host:1"});
  EXPECT_EQ(options.command, Command::Watch);
  EXPECT_EQ(options.playback.endpoint, "host:1");
  EXPECT_FALSE(options.headless);
  EXPECT_EQ(options.playback.buffers.receiver_capacity, 100U);
  EXPECT_EQ(options.playback.buffers.playout_capacity, 30U);
  EXPECT_EQ(options.playback.buffers.threshold_percent, 40);
  EXPECT_FALSE(options.playback.speed.has_value());
  EXPECT_EQ(options.face.mixer, face::Mixer::Maximum);
  EXPECT_EQ(options.face.rules, "facs");
  EXPECT_EQ(options.playback.interpolation, playback::Interpolation::Linear);
  EXPECT_FALSE(options.playback.classic);
  EXPECT_EQ(options.playback.connect_timeout, std::chrono::seconds(10));
  EXPECT_EQ(options.output.width, 800);
  EXPECT_EQ(options.output.height, 600);
  EXPECT_FALSE(options.output.fast);
  EXPECT_FALSE(options.playback.blink.has_value());
  EXPECT_FALSE(options.playback.buffers.low_delay);
}

TEST(PlayerOptions, AStreamFileInPlaceOfAServerIsToldHowItIsPlayed) {
  const test::TempFolder folder;
  const std::string file = folder.write("talk.txt", "Beg_Stream\n1\nEnd_Stream\n").string();
  EXPECT_NE(refused({file}).find("is a file, not a server: play it with face-player play " + file),
            std::string::npos);
  EXPECT_EQ(accepted({folder.path() / "none.txt"}).playback.endpoint, folder.path() / "none.txt");
}

TEST(PlayerOptions, OptionsMayStandBeforeTheCommand) {
  const PlayerOptions play = accepted({"--size", "500x400", "--idle=3", "play", "talk.txt"});
  EXPECT_EQ(play.command, Command::Play);
  EXPECT_EQ(play.playback.file, "talk.txt");
  EXPECT_EQ(play.output.width, 500);
  EXPECT_EQ(accepted({"--face", "play", "host"}).command, Command::Watch) << "the word of --face";
}

TEST(PlayerOptions, VerboseAndQuietAreLevels) {
  EXPECT_EQ(accepted({"host"}).log_level, "warning");
  EXPECT_EQ(accepted({"-v", "host"}).log_level, "info");
  EXPECT_EQ(accepted({"-vv", "host"}).log_level, "debug");
  EXPECT_EQ(accepted({"-q", "host"}).log_level, "error");
  EXPECT_EQ(accepted({"-q", "--log-level", "trace", "host"}).log_level, "trace");
  EXPECT_EQ(accepted({"-v", "--log-level", "off", "host"}).log_level, "off");
  EXPECT_EQ(refused({"-q", "-v", "host"}), "-v and -q exclude each other (try --help)");
}

TEST(PlayerOptions, TheWordOfAnyCommandsOptionIsNoCommand) {
  const PlayerOptions stream = accepted({"--stream", "pose", "host"});
  EXPECT_EQ(stream.command, Command::Watch) << "pose has no --stream";
  EXPECT_EQ(stream.playback.stream, "pose");
  EXPECT_EQ(stream.playback.endpoint, "host");
  EXPECT_EQ(accepted({"--png", "play", "pose", "12"}).command, Command::Pose);
  EXPECT_EQ(accepted({"--headless", "play", "talk.txt"}).command, Command::Play);
  EXPECT_EQ(accepted({"--size", "1x1", "pose"}).command, Command::Pose);
  EXPECT_EQ(accepted({"-q", "rules", "12"}).command, Command::Rules);
  EXPECT_EQ(accepted({"--only", "aus", "gallery", "out"}).command, Command::Gallery);
}

TEST(PlayerOptions, TheFirstWordThatIsNoOptionsDecides) {
  EXPECT_EQ(accepted({"host", "--stream", "pose"}).command, Command::Watch);
  EXPECT_EQ(accepted({"pose", "--expression", "play"}).command, Command::Pose);
}

TEST(PlayerOptions, ARepeatedOptionTakesOneWordEachTime) {
  const PlayerOptions options = accepted({"pose", "--muscle", "jaw=1", "12"});
  EXPECT_EQ(options.pose.muscles.size(), 1U);
  EXPECT_EQ(options.pose.aus, "12");
}

TEST(PlayerOptions, ReadWhatAGalleryNeeds) {
  const PlayerOptions plain = accepted({"gallery", "d"});
  EXPECT_EQ(plain.command, Command::Gallery);
  EXPECT_EQ(plain.gallery.folder, "d");
  EXPECT_EQ(plain.output.width, 300);
  EXPECT_EQ(plain.output.height, 375);
  EXPECT_FALSE(plain.output.background.has_value());
  const PlayerOptions all = accepted({"gallery", "--only", "aus,prototypes", "--only", "sweeps",
                                      "--sweep", "1,2", "--sweep", "fear", "d", "--camera",
                                      "profile", "--background", "00ff7F", "--size", "48x60"});
  EXPECT_EQ(all.gallery.only, (std::vector<std::string>{"aus", "prototypes", "sweeps"}));
  EXPECT_EQ(all.gallery.sweeps, (std::vector<std::string>{"1,2", "fear"}));
  EXPECT_EQ(all.output.background, 0x00FF7FU);
  EXPECT_FALSE(all.output.transparent);
  EXPECT_TRUE(accepted({"gallery", "d", "--background", "none"}).output.transparent);
  EXPECT_EQ(all.output.width, 48);
  for (const char* wrong : {"red", "12345", "1234567", "-12345", "0x1234", " 12345"}) {
    EXPECT_NE(refused({"gallery", "d", "--background", wrong}).find("--background"),
              std::string::npos)
        << wrong;
  }
  EXPECT_NE(refused({"gallery"}).find("needs a folder"), std::string::npos);
  EXPECT_NE(refused({"gallery", "d", "--only", "noses"}).find("--only"), std::string::npos);
}

TEST(PlayerOptions, ReadWhatIsExported) {
  const PlayerOptions alone = accepted({"export", "--face", "marek", "face.glb"});
  EXPECT_EQ(alone.command, Command::Export);
  EXPECT_EQ(alone.exported.glb(), "face.glb");
  EXPECT_EQ(alone.exported.stream(), "");
  EXPECT_EQ(alone.exported.basis, glb::Basis::Muscles);
  const PlayerOptions moved =
      accepted({"export", "talk.txt", "--basis", "aus", "talk.glb", "--fps", "60"});
  EXPECT_EQ(moved.exported.stream(), "talk.txt");
  EXPECT_EQ(moved.exported.glb(), "talk.glb");
  EXPECT_EQ(moved.exported.basis, glb::Basis::Aus);
  EXPECT_EQ(moved.output.fps, 60);
  EXPECT_EQ(accepted({"export", "FACE.GLB"}).exported.glb(), "FACE.GLB");
  EXPECT_NE(refused({"export"}).find("needs FILE.glb"), std::string::npos);
  EXPECT_NE(refused({"export", "talk.txt"}).find("end in .glb"), std::string::npos);
  EXPECT_NE(refused({"export", "a", "b", "c.glb"}).find("needs FILE.glb"), std::string::npos);
  EXPECT_NE(refused({"export", "a.glb", "--basis", "bones"}).find("--basis"), std::string::npos);
}

TEST(PlayerOptions, ReadEverythingAViewerMaySay) {
  const PlayerOptions options =
      accepted({"--headless", "h",           "--buffer", "50",       "--playout",
                "5",          "--threshold", "100",      "--speed",  "1000",
                "--mixer",    "average",     "--rules",  "none",     "--interpolation",
                "cosine",     "--protocol",  "auto",     "--stream", "talk",
                "--face",     "f",           "--data",   "d",        "--connect-timeout",
                "2.5",        "--stats",     "s.json",   "--fps",    "25",
                "--size",     "64x48",       "--blink",  "7"});
  EXPECT_TRUE(options.headless);
  EXPECT_EQ(options.playback.buffers.receiver_capacity, 50U);
  EXPECT_EQ(options.playback.buffers.playout_capacity, 5U);
  EXPECT_EQ(options.playback.buffers.threshold_percent, 100);
  EXPECT_EQ(options.playback.speed, Milliseconds(1000));
  EXPECT_EQ(options.face.mixer, face::Mixer::Average);
  EXPECT_EQ(options.face.rules, "none");
  EXPECT_EQ(options.playback.interpolation, playback::Interpolation::Cosine);
  EXPECT_FALSE(options.playback.classic);
  EXPECT_TRUE(accepted({"h", "--protocol", "classic"}).playback.classic);
  EXPECT_EQ(options.playback.stream, "talk");
  EXPECT_EQ(options.face.face, "f");
  EXPECT_EQ(options.face.data, "d");
  EXPECT_EQ(options.playback.connect_timeout, std::chrono::milliseconds(2500));
  EXPECT_EQ(options.output.stats, "s.json");
  EXPECT_EQ(options.output.fps, 25);
  EXPECT_EQ(options.output.width, 64);
  EXPECT_EQ(options.output.height, 48);
  EXPECT_EQ(options.playback.blink, playback::BlinkOptions{7});
}

TEST(PlayerOptions, StatisticsGoToStandardOutputWithAHyphen) {
  EXPECT_EQ(accepted({"h", "--stats", "-"}).output.stats, "/dev/stdout");
  EXPECT_EQ(accepted({"h", "--stats", "./-"}).output.stats, "./-");
}

TEST(PlayerOptions, IdleLifeBlinksWithItsOwnSeedUnlessToldOtherwise) {
  EXPECT_FALSE(accepted({"play", "x.txt"}).playback.idle_seed.has_value());
  const PlayerOptions idle = accepted({"play", "x.txt", "--idle", "5"});
  EXPECT_EQ(idle.playback.idle_seed, 5U);
  EXPECT_EQ(idle.playback.blink, playback::BlinkOptions{5});
  const PlayerOptions both = accepted({"play", "x.txt", "--blink", "6", "--idle", "5"});
  EXPECT_EQ(both.playback.idle_seed, 5U);
  EXPECT_EQ(both.playback.blink, playback::BlinkOptions{6});
  const PlayerOptions blinks = accepted({"play", "x.txt", "--blink", "6"});
  EXPECT_FALSE(blinks.playback.idle_seed.has_value());
}

TEST(PlayerOptions, BlinkingHasAnIntervalAndAClosingTime) {
  EXPECT_EQ(accepted({"h", "--blink", "7:2000"}).playback.blink,
            (playback::BlinkOptions{.seed = 7, .interval_ms = 2000}));
  EXPECT_EQ(accepted({"h", "--blink", "7:600:75"}).playback.blink,
            (playback::BlinkOptions{.seed = 7, .interval_ms = 600, .closing_ms = 75}));
  for (const char* wrong : {"x", "-1", "7:", "7:499", "7:60001", "7:600:24", "7:600:101",
                            "7:600:75:1", "7:600:", ":600", "7 "}) {
    EXPECT_NE(refused({"h", "--blink", wrong}).find("SEED[:INTERVAL[:CLOSING]]"), std::string::npos)
        << wrong;
  }
}

TEST(PlayerOptions, LiveIsTheLowestDelayAndNoOther) {
  const auto live = accepted({"h", "--live"}).playback.buffers;
  EXPECT_TRUE(live.low_delay);
  EXPECT_TRUE(accepted({"h", "--live", "--buffer", "auto"}).playback.buffers.by_time)
      << "which is for recorded streams";
  EXPECT_NE(refused({"h", "--live", "--live-delay", "100"}).find("--live"), std::string::npos);
  EXPECT_NE(refused({"h", "--live", "--buffer", "100ms"}).find("--live"), std::string::npos);
  EXPECT_NE(refused({"h", "--live", "--sheet", "s.png"}).find("video clock"), std::string::npos);
  EXPECT_NE(refused({"h", "--live", "--fast"}).find("video clock"), std::string::npos);
}

TEST(PlayerOptions, PicturesRunOnTheVideoClock) {
  for (const Arguments& output : {Arguments{"--frames", "d"}, Arguments{"--record", "f.mp4"},
                                  Arguments{"--sheet", "s.png"}, Arguments{"--fast"}}) {
    Arguments arguments{"play", "x.txt"};
    arguments.insert(arguments.end(), output.begin(), output.end());
    const PlayerOptions options = accepted(arguments);
    EXPECT_TRUE(options.output.fast);
    EXPECT_TRUE(options.headless);
  }
}

TEST(PlayerOptions, ASmallBufferShrinksThePlayoutThatWasNotAskedFor) {
  EXPECT_EQ(accepted({"h", "--buffer", "2"}).playback.buffers.playout_capacity, 2U);
  const auto timed = accepted({"h", "--buffer", "750ms"}).playback.buffers;
  EXPECT_TRUE(timed.by_time && !timed.adapt);
  EXPECT_EQ(timed.live_delay, Milliseconds(750));
  const auto adapting = accepted({"h", "--buffer", "auto"}).playback.buffers;
  EXPECT_TRUE(adapting.by_time && adapting.adapt);
  const auto sets = accepted({"h"}).playback.buffers;
  EXPECT_TRUE(!sets.by_time && sets.adapt) << "live streams adapt, recorded ones fill up";
  EXPECT_FALSE(accepted({"h", "--live-delay", "300"}).playback.buffers.adapt);
  for (const char* wrong : {"0", "10001", "ms", "60001ms", "-1ms", "1.5ms", "automatic", ""}) {
    EXPECT_NE(refused({"h", "--buffer", wrong}).find("--buffer"), std::string::npos) << wrong;
  }
  EXPECT_EQ(accepted({"h", "--hold", "0.5"}).playback.hold, Milliseconds(500));
  EXPECT_NE(refused({"h", "--buffer", "2", "--playout", "3"}).find("larger than --buffer 2"),
            std::string::npos);
}

TEST(PlayerOptions, VoiceIsWantedWhereItIsHeardOrWritten) {
  EXPECT_TRUE(accepted({"host"}).playback.voice);
  EXPECT_FALSE(accepted({"host", "--no-sound"}).playback.voice);
  EXPECT_FALSE(accepted({"host", "--headless"}).playback.voice);
  EXPECT_TRUE(accepted({"host", "--headless", "--sound-device", "default"}).playback.voice);
  EXPECT_TRUE(accepted({"host", "--record", "a.mp4"}).playback.voice);
  EXPECT_TRUE(accepted({"host", "--headless", "--record", "A.WEBM"}).playback.voice);
  EXPECT_FALSE(accepted({"host", "--record", "a.mp4", "--no-sound"}).playback.voice);
  EXPECT_FALSE(accepted({"host", "--record", "a.gif"}).playback.voice);
  const PlayerOptions written = accepted({"host", "--sound", "A.WAV", "--volume", "30", "--mute"});
  EXPECT_TRUE(written.playback.voice);
  EXPECT_TRUE(written.output.fast);
  EXPECT_EQ(written.sound.volume, 30);
  EXPECT_TRUE(written.sound.mute);
  refused({"host", "--sound", "a.wav", "--no-sound"});
  refused({"host", "--sound-device", "x", "--no-sound"});
  refused({"host", "--sound", "a.mp3"});
  refused({"host", "--volume", "101"});
}

TEST(PlayerOptions, KnowTheCommands) {
  const PlayerOptions play = accepted({"play", "talk.txt", "--headless", "--buffer", "10"});
  EXPECT_EQ(play.command, Command::Play);
  EXPECT_EQ(play.playback.file, "talk.txt");

  const PlayerOptions pose = accepted({"pose", "6,12", "--muscle", "jaw=1.5", "--muscle", "a=0",
                                       "--png", "p.png", "--obj", "o.obj", "--camera", "profile"});
  EXPECT_EQ(pose.command, Command::Pose);
  EXPECT_EQ(pose.pose.aus, "6,12");
  ASSERT_EQ(pose.pose.muscles.size(), 2U);
  EXPECT_EQ(pose.pose.muscles[0], (std::pair<std::string, float>("jaw", 1.5F)));
  EXPECT_EQ(pose.pose.viewpoint, view::ViewpointPreset::Profile);

  const PlayerOptions rules = accepted({"rules", "51,52", "--rules", "kumar2010", "--explain"});
  EXPECT_EQ(rules.command, Command::Rules);
  EXPECT_TRUE(rules.pose.explain);
  EXPECT_EQ(rules.face.rules, "kumar2010");
}

TEST(PlayerOptions, HelpAndVersionAreTexts) {
  for (const Arguments& arguments : {Arguments{"--help"}, Arguments{"-h"}, Arguments{"--version"},
                                     Arguments{"pose", "--help"}, Arguments{"rules", "--help"}}) {
    const PlayerOptions options = accepted(arguments);
    EXPECT_EQ(options.command, Command::Help);
    EXPECT_FALSE(options.text.empty());
  }
}

TEST(PlayerOptions, TheMirrorsCameraStandsWhereAServerWould) {
  const auto plain = parse_player_options({"--mirror"});
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->shows_mirror);
  EXPECT_EQ(plain->mirror.source, "camera");
  const auto other = parse_player_options({"--mirror", "camera:/dev/video2", "--face", "marek"});
  ASSERT_TRUE(other);
  EXPECT_EQ(other->mirror.source, "camera:/dev/video2");
  EXPECT_EQ(other->playback.endpoint, "");
  EXPECT_NE(refused({"--mirror", "--headless"}).find("--mirror"), std::string::npos);
  EXPECT_NE(refused({"--mirror", "--record", "a.mp4"}).find("--mirror"), std::string::npos);
  EXPECT_NE(refused({"--mirror", "--list"}).find("--mirror"), std::string::npos);
  EXPECT_NE(refused({"--mirror", "--tls"}).find("--tls"), std::string::npos);
  EXPECT_NE(refused({"--mirror", "--live"}).find("leave out --live"), std::string::npos);
}

TEST(PlayerOptions, WithTheMirrorTokenAndCertificateAreForItsGuests) {
  const auto options = parse_player_options(
      {"--mirror", "--token-file", "t", "--tls-cert", "c.pem", "--tls-key", "k.pem"});
  ASSERT_TRUE(options) << options.error().message;
  EXPECT_EQ(options->mirror.token, "t");
  EXPECT_EQ(options->mirror.certificate, "c.pem");
  EXPECT_EQ(options->mirror.key, "k.pem");
  const net::SecurityOptions& shown = options->playback.security;
  EXPECT_TRUE(shown.token.empty()) << "no server is shown it";
  EXPECT_TRUE(shown.files.certificate.empty());
  EXPECT_FALSE(shown.tls);
}

TEST(PlayerOptions, SayHowATableIsReadWherePlayAndExportReadOne) {
  const gui::TableSettings wanted{.fps = 30, .gain_percent = 150, .neutral_s = 2};
  const Arguments settings{"--table-fps", "30", "--table-gain", "150", "--table-neutral", "2"};
  for (const Arguments& command : {Arguments{"play", "t.csv"}, {"export", "t.csv", "t.glb"}}) {
    Arguments all = command;
    all.insert(all.end(), settings.begin(), settings.end());
    EXPECT_EQ(accepted(all).table, wanted);
  }
  EXPECT_NE(refused({"play", "t.csv", "--table-fps", "0"}).find("--table-fps"), std::string::npos);
  EXPECT_NE(refused({"h", "--table-fps", "30"}).find("--table-fps"), std::string::npos);
}

TEST(PlayerOptions, RefuseWithOneLine) {
  EXPECT_NE(refused({"h", "--sped", "1"}).find("did you mean --speed?"), std::string::npos);
  EXPECT_NE(refused({"h", "--speed", "0"}).find("--speed"), std::string::npos);
  EXPECT_NE(refused({"h", "--speed", "1001"}).find("--speed"), std::string::npos);
  EXPECT_NE(refused({"h", "--buffer", "0"}).find("--buffer"), std::string::npos);
  EXPECT_NE(refused({"h", "--buffer", "10001"}).find("--buffer"), std::string::npos);
  EXPECT_NE(refused({"h", "--threshold", "101"}).find("--threshold"), std::string::npos);
  EXPECT_NE(refused({"h", "--mixer", "median"}).find("--mixer"), std::string::npos);
  EXPECT_NE(refused({"h", "--protocol", "udp"}).find("--protocol"), std::string::npos);
  for (const Arguments& named : {Arguments{"h", "--stream", "x"}, Arguments{"aucast://h/x"}}) {
    Arguments classic = named;
    classic.insert(classic.end(), {"--protocol", "classic"});
    EXPECT_NE(refused(classic).find("a stream's name needs a hello"), std::string::npos);
  }
  EXPECT_NE(refused({"h", "--fps", "0"}).find("--fps"), std::string::npos);
  EXPECT_NE(refused({"a", "b"}).find("unexpected argument 'b'"), std::string::npos);
  EXPECT_NE(refused({"--headless"}).find("needs HOST"), std::string::npos);
  EXPECT_NE(refused({"h", "--headless", "--onsets", "o.csv"}).find("--onsets"), std::string::npos);
  EXPECT_NE(refused({"play"}).find("needs a stream FILE"), std::string::npos);
  EXPECT_NE(refused({"rules"}).find("needs a set of AUs"), std::string::npos);
}

TEST(PlayerOptions, RefuseImpossibleSizesAndMuscles) {
  for (const char* size : {"800", "x600", "800x", "0x600", "800x600x2", "99999x1", "axb", "-1x5"}) {
    EXPECT_NE(refused({"pose", "0", "--size", size}).find("--size"), std::string::npos) << size;
  }
  for (const char* muscle : {"jaw", "jaw=", "jaw=x", "jaw=1x", "jaw=nan", "jaw=inf"}) {
    EXPECT_NE(refused({"pose", "--muscle", muscle}).find("--muscle"), std::string::npos) << muscle;
  }
}

TEST(PlayerOptions, LiveDelayAndReconnect) {
  const auto plain = parse_player_options({"host"});
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->playback.buffers.live_delay, std::chrono::milliseconds(300));
  EXPECT_FALSE(plain->playback.reconnect);
  const auto given = parse_player_options({"host", "--live-delay", "0", "--reconnect"});
  ASSERT_TRUE(given);
  EXPECT_EQ(given->playback.buffers.live_delay, std::chrono::milliseconds(0));
  EXPECT_TRUE(given->playback.reconnect);
  const auto late = parse_player_options({"host", "--live-delay", "60001"});
  ASSERT_FALSE(late);
  EXPECT_NE(late.error().message.find("--live-delay"), std::string::npos) << late.error().message;
}

TEST(PlayerOptions, APictureIsAPngAndSoIsItsName) {
  EXPECT_TRUE(parse_player_options({"pose", "6,12", "--png", "a.png"}));
  EXPECT_TRUE(parse_player_options({"pose", "6,12", "--png", "/dev/stdout"}));
  const auto pose = parse_player_options({"pose", "6,12", "--png", "a.jpg"});
  ASSERT_FALSE(pose);
  EXPECT_EQ(pose.error().kind, ErrorKind::Usage);
  EXPECT_NE(pose.error().message.find("--png writes a PNG"), std::string::npos);
  EXPECT_FALSE(parse_player_options({"play", "talk.txt", "--sheet", "a.jpg"}));
}

TEST(PlayerOptions, AStreamsAddressSaysWhatOtherOptionsSayToo) {
  const PlayerOptions one = accepted({"aucast://a:7/talk"});
  EXPECT_EQ(one.playback.endpoint, "a:7");
  EXPECT_EQ(one.playback.stream, "talk");
  EXPECT_FALSE(one.playback.reconnect);
  EXPECT_FALSE(one.playback.security.tls);
  const PlayerOptions more = accepted({"aucasts://a,[::1]:7/talk"});
  EXPECT_EQ(more.playback.endpoint, "a:4650");
  EXPECT_EQ(more.playback.others, (std::vector<protocol::Endpoint>{{"::1", 7}}));
  EXPECT_TRUE(more.playback.reconnect) << "else the second would never be asked";
  EXPECT_TRUE(more.playback.security.tls);
  EXPECT_FALSE(more.playback.one_round) << "the window shows what is tried";
  EXPECT_TRUE(accepted({"aucast://a,b/talk", "--headless"}).playback.one_round);
  EXPECT_FALSE(accepted({"aucast://a,b/talk", "--headless", "--reconnect"}).playback.one_round);
  EXPECT_FALSE(parse_player_options({"aucast://a/talk", "--stream", "six"}));
  EXPECT_FALSE(parse_player_options({"aucast:///talk"}));
}

}  // namespace
}  // namespace aucast::app
