#include "speaker/output_files.h"

#include <gtest/gtest.h>

#include "common/text.h"
#include "common/voice/sound_file.h"
#include "common/voice/webvtt.h"
#include "tests/support/temp_folder.h"

namespace aucast::speaker {
namespace {

namespace fs = std::filesystem;

/// Half a second of a tone, of which two sounds are told apart.
Speech short_speech() {
  Speech speech;
  speech.rate = 16'000;
  for (int i = 0; i < 8000; ++i) speech.samples.push_back(i % 40 < 20 ? 0.5F : -0.5F);
  speech.phonemes = {{"", Milliseconds(0)},
                     {"p", Milliseconds(100)},
                     {"", Milliseconds(150)},
                     {"iː", Milliseconds(200)}};
  return speech;
}

protocol::StreamFile short_stream() {
  protocol::StreamFile stream;
  stream.title = "A talk";
  stream.keyframes.resize(1);
  stream.keyframes.front().terms = {{12, Side::Both, 50}};
  stream.keyframes.front().time_ms = 500;
  return stream;
}

const std::vector<TimedCaption> kCaptions{{Milliseconds(0), Milliseconds(500), "Pea."}};

class OutputFilesTest : public ::testing::Test {
 protected:
  [[nodiscard]] OutputFiles files(const fs::path& narration = {},
                                  const fs::path& labels = {}) const {
    return output_files(out_, "talk", narration, labels);
  }
  [[nodiscard]] std::string refusal(const OutputFiles& files, ErrorKind kind,
                                    const std::vector<fs::path>& inputs = {}) const {
    const auto good = check_outputs(files, inputs);
    if (good) return "none";
    EXPECT_EQ(good.error().kind, kind);
    return good.error().message;
  }

  test::TempFolder folder_;
  fs::path out_ = folder_.path() / "made" / "out";
};

TEST_F(OutputFilesTest, LieTogetherUnderOneName) {
  const OutputFiles dotted = output_files("out", "part.1", {}, "l.txt");
  EXPECT_EQ(dotted.stream, "out/part.1.txt");
  EXPECT_EQ(dotted.captions, "out/part.1.vtt");
  EXPECT_EQ(dotted.voice, "out/part.1.wav");
  EXPECT_EQ(dotted.labels, "l.txt");
}

TEST_F(OutputFilesTest, ANarrationThatIsServedBesideTheStreamIsNotWrittenAgain) {
  fs::create_directories(out_);
  const auto beside = folder_.write("made/out/talk.ogg", "sound");
  const auto elsewhere = folder_.write("talk.ogg", "sound");
  EXPECT_EQ(files(beside).voice, "");
  EXPECT_EQ(files(elsewhere).voice, out_ / "talk.wav");
  EXPECT_EQ(files().voice, out_ / "talk.wav");
}

TEST_F(OutputFilesTest, AreAllWrittenAndHoldWhatWasMade) {
  const OutputFiles all = files({}, folder_.path() / "labels.txt");
  ASSERT_TRUE(write_outputs(all, short_speech(), short_stream(), kCaptions));
  EXPECT_EQ(folder_.read("made/out/talk.txt"),
            "# title: A talk\nBeg_Stream\n12:50;500\nEnd_Stream\n");
  const auto captions = voice::parse_webvtt(folder_.read("made/out/talk.vtt"), "talk.vtt");
  ASSERT_TRUE(captions);
  EXPECT_EQ(captions->front().text, "Pea.");
  auto sound = voice::SoundFile::open(all.voice);
  ASSERT_TRUE(sound) << sound.error().message;
  EXPECT_EQ(sound->duration(), Milliseconds(500));
  EXPECT_EQ(folder_.read("labels.txt"), "0.100\t0.150\tp\n0.200\t0.500\tiː\n");
}

TEST_F(OutputFilesTest, NoneGetsItsNameWhereTheLabelsCannotBeWritten) {
  for (const fs::path& labels : {folder_.path() / "none" / "labels.txt", folder_.path()}) {
    EXPECT_FALSE(write_outputs(files({}, labels), short_speech(), short_stream(), kCaptions));
    EXPECT_TRUE(fs::is_empty(out_)) << labels;
  }
}

TEST_F(OutputFilesTest, AreRefusedBeforeTheWorkWhereTheyCannotBeWritten) {
  const fs::path nowhere = folder_.path() / "none" / "labels.txt";
  EXPECT_EQ(refusal(files({}, nowhere), ErrorKind::Failed),
            nowhere.string() +
                ": cannot be written: No such file or directory; choose another "
                "folder");
  EXPECT_EQ(refusal(files({}, folder_.path()), ErrorKind::Failed),
            folder_.path().string() + ": cannot be written: it is a folder");
  EXPECT_EQ(refusal(files(), ErrorKind::Failed), "none") << "the folder will be made";
  EXPECT_EQ(refusal(files({}, out_ / "labels.txt"), ErrorKind::Failed), "none");
  EXPECT_EQ(refusal(files({}, out_ / ".." / "labels.txt"), ErrorKind::Failed), "none");
  EXPECT_FALSE(fs::exists(folder_.path() / "made")) << "nothing is made by asking";
  fs::create_directories(out_ / "talk.vtt");
  EXPECT_EQ(refusal(files(), ErrorKind::Failed),
            (out_ / "talk.vtt").string() + ": cannot be written: it is a folder");
}

TEST_F(OutputFilesTest, NeverReplaceAnInputOrEachOther) {
  fs::create_directories(out_);
  const auto text = folder_.write("made/out/talk.txt", "Pea.\n");
  EXPECT_NE(refusal(files(), ErrorKind::Usage, {text}).find("would be written over"),
            std::string::npos);
  EXPECT_NE(refusal(files({}, out_ / "talk.vtt"), ErrorKind::Usage).find("written twice"),
            std::string::npos);
}

TEST(LabelsOf, TheLastSoundLastsUntilTheEndAndPausesHaveNoLine) {
  Speech speech = short_speech();
  EXPECT_EQ(labels_of(speech), "0.100\t0.150\tp\n0.200\t0.500\tiː\n");
  speech.phonemes.clear();
  EXPECT_EQ(labels_of(speech), "");
}

}  // namespace
}  // namespace aucast::speaker
