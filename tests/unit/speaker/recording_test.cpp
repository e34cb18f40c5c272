#include "speaker/recording.h"

#include <sndfile.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/voice/voice_encoder.h"
#include "tests/support/temp_folder.h"

namespace aucast::speaker {
namespace {

using namespace std::chrono_literals;

class RecordingTest : public ::testing::Test {
 protected:
  void write(Milliseconds length) const {
    SF_INFO info{};
    info.samplerate = voice::kEncoderRate;
    info.channels = 1;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SNDFILE* const file = sf_open(path_.c_str(), SFM_WRITE, &info);
    const std::vector<float> samples(
        static_cast<std::size_t>(length.count()) * voice::kEncoderSamplesPerMs, 0.25F);
    sf_writef_float(file, samples.data(), static_cast<sf_count_t>(samples.size()));
    sf_close(file);
  }
  [[nodiscard]] Error refusal(Milliseconds said, Milliseconds longest = kRecordingMax) const {
    const auto read = read_recording(path_, said, longest);
    return read ? Error{ErrorKind::Failed, "it was read"} : read.error();
  }
  [[nodiscard]] Error bad(const std::string& why) const {
    return {ErrorKind::BadData, path_.string() + ": " + why};
  }

  test::TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "talk.wav";
};

TEST_F(RecordingTest, IsReadWhole) {
  write(62s);  // more than is read at a time
  const auto samples = read_recording(path_, 50s);
  ASSERT_TRUE(samples) << samples.error().message;
  EXPECT_NEAR(static_cast<double>(samples->size()), 62.0 * voice::kEncoderRate, 200);
}

TEST_F(RecordingTest, OneThatIsTooLongIsRefusedAndNotCut) {
  write(90s);
  EXPECT_TRUE(read_recording(path_, 50s, 90s));
  EXPECT_EQ(refusal(50s, 61s), bad("lasts more than 61 s, the longest that is read; cut it and its "
                                   "text into parts"));
}

TEST_F(RecordingTest, OneThatCannotBeTheTextIsRefused) {
  write(10s);
  EXPECT_TRUE(read_recording(path_, 2500ms));
  EXPECT_TRUE(read_recording(path_, 39s));
  EXPECT_EQ(refusal(2s), bad("lasts more than 8 s, its text about 2 s: is it a reading of that "
                             "text?"));
  EXPECT_EQ(refusal(41s), bad("lasts 10 s, its text about 41 s: is it a reading of that text?"));
}

TEST_F(RecordingTest, OneThatIsNotThereIsUnreadable) {
  EXPECT_EQ(refusal(2s).kind, ErrorKind::Unreadable);
}

}  // namespace
}  // namespace aucast::speaker
