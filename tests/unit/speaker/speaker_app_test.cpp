#include "speaker/speaker_app.h"

#include <gtest/gtest.h>
#include <sndfile.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <random>

#include "common/text.h"
#include "common/voice/sound_file.h"
#include "common/voice/voice_encoder.h"
#include "protocol/stream_file.h"
#include "speaker/espeak_voice.h"
#include "tests/support/process.h"
#include "tests/support/sanitized.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::speaker {
namespace {

using aucast::test::TempFolder;

TEST(SpeakerApp, MakesSpeechFaceAndCaptions) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "# title: A talk\nGood morning.\n").string();
  const std::string out = (folder.path() / "out").string();
  ASSERT_EQ(run_speaker({text, "-o", out}), 0);
  const std::string stream = folder.read("out/talk.txt");
  EXPECT_TRUE(stream.starts_with("# title: A talk\nBeg_Stream\n"));
  EXPECT_TRUE(protocol::parse_stream_file(stream, "talk.txt"));
  EXPECT_NE(folder.read("out/talk.vtt").find("Good morning."), std::string::npos);
  const auto sound = voice::SoundFile::open(folder.path() / "out/talk.wav");
  ASSERT_TRUE(sound) << sound.error().message;
  EXPECT_GT(sound->duration(), Milliseconds(500));
}

TEST(SpeakerApp, GivesARecordedVoiceAFace) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning, everybody.\n").string();
  const std::string out = (folder.path() / "out").string();
  ASSERT_EQ(run_speaker({text, "-o", out, "--speed", "120"}), 0);
  const std::string voice = (folder.path() / "out/talk.wav").string();
  const std::string again = (folder.path() / "again").string();
  ASSERT_EQ(run_speaker({text, "-o", again, "--voice", voice}), 0);
  EXPECT_TRUE(protocol::parse_stream_file(folder.read("again/talk.txt"), "talk.txt"));
}

/// Of a sound file, as clients are sent it.
std::vector<float> samples_of(const std::filesystem::path& path) {
  auto file = voice::SoundFile::open(path);
  EXPECT_TRUE(file.has_value());
  std::vector<float> samples(std::size_t{60} * voice::kEncoderRate);
  if (file) samples.resize(file->read(samples));
  return samples;
}

TEST(SpeakerApp, ANarrationIsTheVoiceOfItsStream) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning, everybody.\n").string();
  const std::string out = (folder.path() / "out").string();
  ASSERT_EQ(run_speaker({text, "-o", out, "--speed", "120"}), 0);
  const auto reading = folder.path() / "read.wav";
  std::filesystem::rename(out + "/talk.wav", reading);
  // A voice that was made is there already.
  ASSERT_EQ(run_speaker({text, "-o", out}), 0);
  ASSERT_EQ(run_speaker({text, "-o", out, "--voice", reading.string()}), 0);
  const auto wanted = samples_of(reading);
  const auto kept = samples_of(out + "/talk.wav");
  ASSERT_EQ(kept.size(), wanted.size());
  EXPECT_GT(voice::test::correlation(kept, wanted, 0), 0.99);
}

TEST(SpeakerApp, ANarrationBesideItsStreamStaysAsItIs) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning, everybody.\n").string();
  const std::string out = (folder.path() / "out").string();
  ASSERT_EQ(run_speaker({text, "-o", out}), 0);
  const std::string before = folder.read("out/talk.wav");
  ASSERT_EQ(run_speaker({text, "-o", out, "--voice", out + "/talk.wav"}), 0);
  EXPECT_EQ(folder.read("out/talk.wav"), before);
  // Under a name that comes later, it is the voice as well.
  std::filesystem::rename(out + "/talk.wav", out + "/talk.flac");
  ASSERT_EQ(run_speaker({text, "-o", out, "--voice", out + "/talk.flac"}), 0);
  EXPECT_FALSE(std::filesystem::exists(out + "/talk.wav"));
}

/// A file of four seconds that nobody speaks in.
std::string sound_of(const TempFolder& folder, const std::function<float(int)>& sample) {
  Speech sound;
  sound.rate = voice::kEncoderRate;
  for (int i = 0; i < 4 * sound.rate; ++i) sound.samples.push_back(sample(i));
  const auto path = folder.path() / "sound.wav";
  SF_INFO info{};
  info.samplerate = sound.rate;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  SNDFILE* const file = sf_open(path.c_str(), SFM_WRITE, &info);
  sf_writef_float(file, sound.samples.data(), static_cast<sf_count_t>(sound.samples.size()));
  sf_close(file);
  return path.string();
}

TEST(SpeakerApp, WarnsOfANarrationThatIsNoReading) {
  const TempFolder folder;
  const std::string text =
      folder.write("talk.txt", "Good morning. Faces have more than forty muscles.\n").string();
  const std::string out = (folder.path() / "out").string();
  std::minstd_rand random;
  const auto noise = [&random](int) { return static_cast<float>(random() % 1000) / 1000 - 0.5F; };
  for (const std::function<float(int)>& sample :
       {std::function<float(int)>([](int) { return 0.0F; }), std::function<float(int)>(noise)}) {
    const std::string sound = sound_of(folder, sample);
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_speaker({text, "-o", out, "--voice", sound}), 0);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "au-speaker: " + sound +
                  ": hardly sounds like a reading of the text; is it the right file?\n");
  }
  ASSERT_EQ(run_speaker({text, "-o", out, "--pitch", "90", "--speed", "110"}), 0);
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_speaker({text, "-o", out, "--voice", out + "/talk.wav"}), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(SpeakerApp, ANarrationThatWasCutOffIsToldOfAndGetsItsFace) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning, everybody.\n").string();
  const std::string out = (folder.path() / "out").string();
  ASSERT_EQ(run_speaker({text, "-o", out}), 0);
  const std::string voice = (folder.path() / "out/talk.wav").string();
  std::filesystem::resize_file(voice, std::filesystem::file_size(voice) - 100);
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_speaker({text, "-o", (folder.path() / "again").string(), "--voice", voice}), 0);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(said.starts_with("au-speaker: " + voice + ": the sound breaks off before its end: "))
      << said;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "again/talk.txt"));
}

TEST(SpeakerApp, TellsWhenEachSoundIsHeard) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Pea.\n").string();
  const std::string labels = (folder.path() / "labels.txt").string();
  ASSERT_EQ(run_speaker({text, "-o", (folder.path() / "out").string(), "--labels", labels}), 0);
  const std::string told = folder.read("labels.txt");
  EXPECT_NE(told.find("\tp"), std::string::npos) << told;
  EXPECT_NE(told.find("i\xcb\x90"), std::string::npos) << "a long i: " << told;
}

TEST(SpeakerApp, ANarrationThatCannotBeTheTextIsRefused) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Hello.\n").string();
  const std::string all = folder.write("long.txt", std::string(400, 'a') + " and so on.").string();
  const std::string out = (folder.path() / "out").string();
  ASSERT_EQ(run_speaker({text, "-o", out}), 0);
  EXPECT_EQ(run_speaker({all, "-o", out, "--voice", out + "/talk.wav"}), 3);
}

TEST(SpeakerApp, TheSameTextAndSeedGiveTheSameFiles) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning. [smile] Hello?\n").string();
  const auto speak_into = [&](const std::string& out, const std::string& seed) {
    const auto done = test::run(
        {test::program("au-speaker"), text, "-o", (folder.path() / out).string(), "--seed", seed});
    EXPECT_EQ(done.exit_code, 0) << done.err;
  };
  speak_into("one", "1");
  speak_into("same", "1");
  speak_into("other", "2");
  for (const char* file : {"/talk.txt", "/talk.vtt", "/talk.wav"}) {
    EXPECT_EQ(folder.read("one" + std::string(file)), folder.read("same" + std::string(file)));
  }
  EXPECT_EQ(folder.read("one/talk.wav"), folder.read("other/talk.wav"));
  EXPECT_NE(folder.read("one/talk.txt"), folder.read("other/talk.txt"));
}

TEST(SpeakerApp, RefusesNumbersOutOfRange) {
  for (const auto& [option, number] :
       std::vector<std::pair<std::string, std::string>>{{"--speed", "79"},
                                                        {"--speed", "451"},
                                                        {"--pitch", "100"},
                                                        {"--gestures", "201"},
                                                        {"--gestures", "-1"},
                                                        {"--seed", "-1"},
                                                        {"--seed", "x"}}) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_speaker({option, number, "talk.txt"}), 2);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(
        said.starts_with("au-speaker: " + option + " '" + number + "' is not a whole number from "))
        << said;
  }
}

TEST(SpeakerApp, PrintsItsManualAndTheVoices) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_speaker({"--help-man"}), 0);
  const std::string manual = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(manual.starts_with(".TH")) << manual.substr(0, 80);
  EXPECT_NE(manual.find("labels"), std::string::npos);
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_speaker({"--list-voices"}), 0);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("de\tGerman\n"), std::string::npos);
}

TEST(SpeakerApp, ReadsStandardInput) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning.\n").string();
  const int before = ::dup(STDIN_FILENO);
  ASSERT_NE(std::freopen(text.c_str(), "r", stdin), nullptr);
  EXPECT_EQ(run_speaker({"-", "-o", (folder.path() / "out").string()}), 0);
  ::dup2(before, STDIN_FILENO);
  ::close(before);
  EXPECT_TRUE(protocol::parse_stream_file(folder.read("out/speech.txt"), "speech.txt"));
}

TEST(SpeakerApp, NeverWritesOverTheText) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning.\n").string();
  EXPECT_EQ(run_speaker({text, "-o", folder.path().string()}), 2);
  EXPECT_EQ(folder.read("talk.txt"), "Good morning.\n");
  const std::string out = (folder.path() / "out").string();
  EXPECT_EQ(run_speaker({text, "-o", out, "--labels", text}), 2);
  EXPECT_EQ(folder.read("talk.txt"), "Good morning.\n");
  const std::string captions = folder.write("talk.vtt", "Good morning.\n").string();
  EXPECT_EQ(run_speaker({captions, "-o", folder.path().string()}), 2);
  EXPECT_EQ(folder.read("talk.vtt"), "Good morning.\n");
}

TEST(SpeakerApp, SaysThatTheTextHasTheNameOfTheFolder) {
  const TempFolder folder;
  const std::string text = folder.write("talk", "Good morning.\n").string();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_speaker({text, "-o", text}), 1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "au-speaker: " + text +
                ": no folder can be made: a file has this name; name another one (--output)\n");
  EXPECT_EQ(folder.read("talk"), "Good morning.\n");
}

TEST(SpeakerApp, AFolderThatIsALinkToItselfIsSaid) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning.\n").string();
  const auto loop = folder.path() / "loop";
  std::filesystem::create_symlink("loop", loop);
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_speaker({text, "-o", loop.string()}), 1);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("no folder can be made"),
            std::string::npos);
}

/// What RLIMIT_FSIZE does to a write is what a full disk does: it fails half-way.
void speak_into_little_room(const std::string& text, const std::string& out) {
  const rlimit limit{16'384, 16'384};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::_Exit(run_speaker({text, "-o", out}));
}

TEST(SpeakerApp, SaysWhyTheSoundIsNotWhole) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning.\n").string();
  const std::string out = (folder.path() / "out").string();
  EXPECT_EXIT(speak_into_little_room(text, out), testing::ExitedWithCode(1),
              "talk.wav: cannot be written whole: .*File too large");
  EXPECT_FALSE(std::filesystem::exists(out + "/talk.wav"));
}

TEST(SpeakerApp, WhatFailsLeavesTheFilesOfTheLastRun) {
  const TempFolder folder;
  const std::string first = folder.write("talk.txt", "Hello.\n").string();
  const std::string second = folder.write("more.txt", "Good morning, everybody.\n").string();
  const std::string out = (folder.path() / "out").string();
  ASSERT_EQ(run_speaker({first, "-o", out}), 0);
  const std::string stream = folder.read("out/talk.txt");
  const std::string captions = folder.read("out/talk.vtt");
  const auto speak_again = [&] {
    const rlimit limit{16'384, 16'384};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::_Exit(run_speaker({second, "-o", out, "--name", "talk"}));
  };
  EXPECT_EXIT(speak_again(), testing::ExitedWithCode(1), "talk.wav: cannot be written whole");
  EXPECT_EQ(folder.read("out/talk.txt"), stream);
  EXPECT_EQ(folder.read("out/talk.vtt"), captions);
  const std::filesystem::directory_iterator files(out);
  EXPECT_EQ(std::distance(begin(files), end(files)), 3) << "none is left half-written";
}

TEST(SpeakerApp, NeverWritesOverTheLabels) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning.\n").string();
  const std::string out = (folder.path() / "out").string();
  EXPECT_EQ(run_speaker({text, "-o", out, "--labels", out + "/../out/talk.txt"}), 2);
  EXPECT_EQ(run_speaker({text, "-o", out, "--labels", out + "/talk.wav"}), 2);
  EXPECT_EQ(run_speaker({text, "-o", out, "--labels", out + "/labels.txt"}), 0);
}

TEST(SpeakerApp, ANameThatLeavesTheFolderIsRefusedBeforeTheWork) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning.\n").string();
  const std::string out = (folder.path() / "out").string();
  folder.write("x.txt", "mine");
  for (const std::string name : {"../x", "a/b", "/x", "x/"}) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_speaker({text, "-o", out, "--name", name}), 2);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "au-speaker: --name '" + name +
                  "' has a '/', which no file's name has; --output names the folder (try "
                  "--help)\n");
  }
  EXPECT_EQ(folder.read("x.txt"), "mine");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(SpeakerApp, LabelsThatCannotBeWrittenAreSaidBeforeTheWork) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good morning.\n").string();
  const std::string out = (folder.path() / "out").string();
  for (const std::string& labels : {out + "/../none/labels.txt", folder.path().string()}) {
    EXPECT_EQ(run_speaker({text, "-o", out, "--labels", labels}), 1);
    EXPECT_FALSE(std::filesystem::exists(out)) << labels;
  }
}

TEST(SpeakerApp, LabelsGoToStandardOutputAlone) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Pea.\n").string();
  const std::string out = (folder.path() / "out").string();
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_speaker({text, "-o", out, "--labels", "-"}), 0);
  std::string labels = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(testing::internal::GetCapturedStderr().starts_with(out + "/talk.txt: "));
  ASSERT_TRUE(labels.ends_with("\n"));
  labels.pop_back();
  for (const std::string_view line : split(labels, '\n')) {
    EXPECT_EQ(split(line, '\t').size(), 3U) << line;
  }
  EXPECT_FALSE(std::filesystem::exists("-"));
  EXPECT_TRUE(std::filesystem::exists(out + "/talk.wav"));
}

TEST(SpeakerApp, TellsItsVersionProtocolAndLicence) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_speaker({"--version"}), 0);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(said.starts_with("au-speaker ")) << said;
  EXPECT_TRUE(said.ends_with(" (protocol 2), GPL-3.0-or-later, as it links espeak-ng and FFTW\n"))
      << said;
}

TEST(SpeakerApp, ATextWithoutWordsIsRefused) {
  const TempFolder folder;
  const std::string out = (folder.path() / "out").string();
  for (const std::string text : {"", "# only a comment\n\n[smile]\n", "...—–\n", "« … »\n"}) {
    const std::string file = folder.write("talk.txt", text).string();
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_speaker({file, "-o", out}), 3) << text;
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "au-speaker: " + file + ": there are no words to speak\n");
  }
}

TEST(SpeakerApp, ATextThatIsTooLongToSpeakIsRefused) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "And so on. ";
  const auto spoken = speak(text, {}, Milliseconds(5000));
  ASSERT_FALSE(spoken);
  EXPECT_EQ(spoken.error().kind, ErrorKind::BadData);
  EXPECT_EQ(spoken.error().message,
            "takes more than 0:05 to speak, the longest that is spoken; cut it into parts");
  EXPECT_TRUE(speak("Good morning.", {}, Milliseconds(5000))) << "the library goes on";
}

TEST(SpeakerApp, SaysThatThereIsNotEnoughMemory) {
  if (test::kSanitized) GTEST_SKIP() << "a sanitizer has its own limits";
  const TempFolder folder;
  std::string text;
  for (int i = 0; i < 1500; ++i) text += "And so on. ";
  const std::string file = folder.write("talk.txt", text).string();
  const std::string out = (folder.path() / "out").string();
  const auto done = test::run({"sh", "-c", "ulimit -v 150000; exec \"$0\" \"$@\"",
                               test::program("au-speaker"), file, "-o", out, "--speed", "80"});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_EQ(done.err, "au-speaker: there is not enough memory left to go on\n");
}

TEST(SpeakerApp, WarnsOfANameThatNoStreamCanHave) {
  const TempFolder folder;
  const std::string text = folder.write("my talk.txt", "Good morning.\n").string();
  const std::string out = (folder.path() / "out").string();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_speaker({text, "-o", out}), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "au-speaker: au-transmitter will not serve 'my talk': a stream's name has 1 to 64 "
            "letters, digits, '.', '_' or '-'; choose another one (--name)\n");
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_speaker({text, "-o", out, "--name", "talk"}), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(SpeakerApp, WarnsOfATitleThatNobodyGets) {
  const TempFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string text =
      folder.write("talk.txt", "# A talk.\n# title: " + std::string(121, 'a') + "\nGood morning.\n")
          .string();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_speaker({text, "-o", out}), 0);
  EXPECT_EQ(
      testing::internal::GetCapturedStderr(),
      "au-speaker: " + text + ":2:1: the title is left out: it has 121 bytes, of at most 120\n");
}

TEST(SpeakerApp, ExitCodesAreThoseOfTheOtherPrograms) {
  const TempFolder folder;
  const std::string text = folder.write("talk.txt", "Good [morning]\n").string();
  EXPECT_EQ(run_speaker({"--help"}), 0);
  EXPECT_EQ(run_speaker({}), 2);
  EXPECT_EQ(run_speaker({"--no-such-option"}), 2);
  EXPECT_EQ(run_speaker({text}), 3);
  EXPECT_EQ(run_speaker({(folder.path() / "none.txt").string()}), 4);
}

}  // namespace
}  // namespace aucast::speaker
