#include "speaker/narration.h"

#include <sndfile.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/voice/voice_encoder.h"
#include "tests/support/temp_folder.h"

namespace aucast::speaker {
namespace {

using namespace std::chrono_literals;

class NarrationTest : public ::testing::Test {
 protected:
  void write(Milliseconds length, int format = SF_FORMAT_WAV | SF_FORMAT_PCM_16) const {
    SF_INFO info{};
    info.samplerate = voice::kEncoderRate;
    info.channels = 1;
    info.format = format;
    SNDFILE* const file = sf_open(path_.c_str(), SFM_WRITE, &info);
    const std::vector<float> samples(
        static_cast<std::size_t>(length.count()) * voice::kEncoderSamplesPerMs, 0.25F);
    sf_writef_float(file, samples.data(), static_cast<sf_count_t>(samples.size()));
    sf_close(file);
  }
  [[nodiscard]] Error refusal(Milliseconds said, Milliseconds longest = kSpeechMax) const {
    const auto read = read_narration(path_, said, longest);
    return read ? Error{ErrorKind::Failed, "it was read"} : read.error();
  }
  [[nodiscard]] Error bad(const std::string& why) const {
    return {ErrorKind::BadData, path_.string() + ": " + why};
  }

  test::TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "talk.wav";
};

TEST_F(NarrationTest, IsReadWhole) {
  write(62s);  // more than is read at a time
  const auto narration = read_narration(path_, 50s);
  ASSERT_TRUE(narration) << narration.error().message;
  EXPECT_NEAR(static_cast<double>(narration->samples.size()), 62.0 * voice::kEncoderRate, 200);
  EXPECT_EQ(narration->complaint, "");
}

TEST_F(NarrationTest, OneThatIsShorterThanItSaysIsReadAndToldOf) {
  write(10s);
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 100);
  const std::string why = path_.string() +
                          ": the sound breaks off before its end: of 320000 bytes of sound it "
                          "has 319900";
  const auto narration = read_narration(path_, 10s);
  ASSERT_TRUE(narration) << narration.error().message;
  EXPECT_NEAR(static_cast<double>(narration->samples.size()), 10.0 * voice::kEncoderRate, 200);
  EXPECT_EQ(narration->complaint, why);
  EXPECT_EQ(refusal(41s), (Error{ErrorKind::BadData, why})) << "why it cannot be the text";
}

TEST_F(NarrationTest, OneThatIsDamagedIsRefused) {
  write(10s, SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III);
  std::string bytes = folder_.read("talk.wav");
  bytes.insert(bytes.size() / 2, 5000, 'U');
  folder_.write("talk.wav", bytes);
  const Error error = refusal(10s);
  EXPECT_EQ(error.kind, ErrorKind::BadData);
  EXPECT_NE(error.message.find("the sound breaks off"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("(ffmpeg -i OLD NEW keeps"), std::string::npos) << error.message;
}

TEST_F(NarrationTest, OneThatIsTooLongIsRefusedAndNotCut) {
  write(90s);
  EXPECT_TRUE(read_narration(path_, 50s, 90s));
  EXPECT_EQ(refusal(50s, 61s), bad("lasts more than 61 s, the longest that is read; cut it and its "
                                   "text into parts"));
}

TEST_F(NarrationTest, OneThatCannotBeTheTextIsRefused) {
  write(10s);
  EXPECT_TRUE(read_narration(path_, 2500ms));
  EXPECT_TRUE(read_narration(path_, 39s));
  EXPECT_EQ(refusal(2s), bad("lasts more than 8 s, its text about 2 s: is it a reading of that "
                             "text?"));
  EXPECT_EQ(refusal(41s), bad("lasts 10 s, its text about 41 s: is it a reading of that text?"));
}

TEST_F(NarrationTest, OneThatIsNotThereIsUnreadable) {
  EXPECT_EQ(refusal(2s).kind, ErrorKind::Unreadable);
}

}  // namespace
}  // namespace aucast::speaker
