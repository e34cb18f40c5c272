#include "common/voice/sound_file.h"

#include <gtest/gtest.h>
#include <sndfile.h>
#include <sys/stat.h>

#include "common/files.h"
#include "common/voice/sound_reader.h"
#include "common/voice/voice_encoder.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::voice {
namespace {

using aucast::test::TempFolder;
using test::correlation;
using test::speech_like;

std::filesystem::path write_sound(const TempFolder& folder, const char* name, int format, int rate,
                                  int channels, double seconds) {
  const auto path = folder.path() / name;
  SF_INFO info{};
  info.samplerate = rate;
  info.channels = channels;
  info.format = format;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  for (const float sample : speech_like(seconds, rate)) {
    const std::vector<float> frame(static_cast<std::size_t>(channels), sample);
    sf_writef_float(file, frame.data(), 1);
  }
  sf_close(file);
  return path;
}

std::vector<float> read_all(SoundFile& file) {
  std::vector<float> all(20 * kEncoderRate);
  all.resize(file.read(all));
  return all;
}

TEST(SoundFile, EveryFormatRateAndChannelCountIsTheSameSound) {
  const TempFolder folder;
  const std::vector<float> source = speech_like(2);
  struct Row {
    const char* name;
    int format;
    int rate;
    int channels;
  };
  const Row rows[] = {
      {"a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 16000, 1},
      {"b.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 44100, 2},
      {"c.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 48000, 1},
      {"d.ogg", SF_FORMAT_OGG | SF_FORMAT_VORBIS, 22050, 1},
      {"e.opus", SF_FORMAT_OGG | SF_FORMAT_OPUS, 48000, 1},
      {"f.mp3", SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III, 44100, 2},
  };
  for (const Row& row : rows) {
    const auto path = write_sound(folder, row.name, row.format, row.rate, row.channels, 2);
    auto file = SoundFile::open(path);
    ASSERT_TRUE(file) << row.name << ": " << file.error().message;
    EXPECT_NEAR(static_cast<double>(file->duration().count()), 2000, 10) << row.name;
    const auto samples = read_all(*file);
    EXPECT_NEAR(static_cast<double>(samples.size()), 2 * kEncoderRate, 200) << row.name;
    EXPECT_GT(correlation(source, samples, 0), 0.95) << row.name;
  }
}

TEST(SoundFile, SaysWhyThereIsNoSound) {
  const TempFolder folder;
  const auto missing = SoundFile::open(folder.path() / "none.wav");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(missing.error().message.find("No such file"), std::string::npos);

  const auto text = SoundFile::open(folder.write("text.wav", "no sound"));
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().kind, ErrorKind::BadData);
}

/// What is said of a file after it was read to its end.
std::string complaint_of(const std::filesystem::path& path) {
  auto file = SoundFile::open(path);
  if (!file) return file.error().message;
  static_cast<void>(read_all(*file));
  return file->complaint();
}

TEST(SoundFile, SaysThatItBreaksOff) {
  const TempFolder folder;
  struct Row {
    const char* name;
    int format;
    const char* why;
    bool damaged;
  };
  const Row rows[] = {
      {"a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, "of 192000 bytes of sound it has ", false},
      {"b.wav", SF_FORMAT_RF64 | SF_FORMAT_PCM_16, "of 192000 bytes of sound it has ", false},
      {"c.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, "", true},
      {"d.mp3", SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III, " frames it has ", false},
  };
  for (const Row& row : rows) {
    const auto path = write_sound(folder, row.name, row.format, 48000, 1, 2);
    EXPECT_EQ(complaint_of(path), "");
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    auto half = SoundFile::open(path);
    ASSERT_TRUE(half) << half.error().message;
    const std::size_t count = read_all(*half).size();
    EXPECT_GT(count, 0U);
    EXPECT_LT(count, std::size_t{2 * kEncoderRate});
    const std::string why = half->complaint();
    EXPECT_TRUE(why.starts_with(path.string() + ": the sound breaks off"))
        << row.name << ": " << why;
    EXPECT_NE(why.find(row.why), std::string::npos) << why;
    EXPECT_EQ(half->damaged(), row.damaged) << why;
  }
}

TEST(SoundFile, SaysThatTheLastPageOfAnOggFileIsMissing) {
  const TempFolder folder;
  for (const int codec : {SF_FORMAT_VORBIS, SF_FORMAT_OPUS}) {
    const auto path = write_sound(folder, "a.ogg", SF_FORMAT_OGG | codec, 48000, 1, 9);
    EXPECT_EQ(complaint_of(path), "");
    const std::string whole = folder.read("a.ogg");
    const std::size_t last_page = whole.rfind("OggS");

    folder.write("a.ogg", whole.substr(0, last_page));
    auto short_of_a_page = SoundFile::open(path);
    ASSERT_TRUE(short_of_a_page);
    EXPECT_GT(read_all(*short_of_a_page).size(), 0U);
    EXPECT_NE(short_of_a_page->complaint().find("breaks off before its end: its last page"),
              std::string::npos);
    EXPECT_FALSE(short_of_a_page->damaged());

    folder.write("a.ogg", whole.substr(0, last_page + 100));
    const std::string why = complaint_of(path);
    EXPECT_NE(why.find("it was cut off"), std::string::npos) << why;
    EXPECT_EQ(why.find("hours"), std::string::npos) << why;
  }
}

TEST(SoundFile, AWavFileFromAPipeIsNotCutOff) {
  const TempFolder folder;
  const auto path = write_sound(folder, "a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 16000, 1, 1);
  std::string bytes = folder.read("a.wav");
  const std::size_t size = bytes.find("data") + 4;
  for (const char* unknown : {"\xff\xff\xff\xff", "\x00\xf0\xff\x7f"}) {
    bytes.replace(size, 4, std::string(unknown, 4));
    folder.write("a.wav", bytes);
    auto file = SoundFile::open(path);
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_NEAR(static_cast<double>(read_all(*file).size()), kEncoderRate, 10);
    EXPECT_EQ(file->complaint(), "");
  }
}

TEST(SoundFile, AnMp3FileIsReadWithoutAWordOfTheLibrarys) {
  const TempFolder folder;
  const int format = SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III;
  const auto path = write_sound(folder, "a.mp3", format, 44100, 1, 4);
  const std::string whole = folder.read("a.mp3");
  const std::size_t half = whole.size() / 2;
  for (const std::string& broken :
       {whole.substr(0, half), whole.substr(0, half) + std::string(5000, 'U') + whole.substr(half),
        std::string("ID3\x04\0\0\0\0\0\x05junk", 14) + std::string(300, '\0') + whole}) {
    folder.write("a.mp3", broken);
    testing::internal::CaptureStderr();
    static_cast<void>(complaint_of(path));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
}

TEST(SoundFile, AnMp3FileIsWholeWhateverIsBehindItsLastFrame) {
  const TempFolder folder;
  const int format = SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III;
  const auto path = write_sound(folder, "a.mp3", format, 44100, 1, 4);
  const std::string whole = folder.read("a.mp3");
  const std::string tags = std::string(4096, '\0') + "LYRICSBEGIN" + std::string(4096, 'a');
  std::string untold = whole;
  const std::size_t header = std::min(whole.find("Xing"), whole.find("Info"));
  ASSERT_NE(header, std::string::npos);
  untold.replace(header, 4, 4, '\0');
  for (const std::string& sound : {whole, untold}) {
    folder.write("a.mp3", sound);
    auto plain = SoundFile::open(path);
    ASSERT_TRUE(plain);
    const std::size_t count = read_all(*plain).size();
    folder.write("a.mp3", sound + tags);
    auto tagged = SoundFile::open(path);
    ASSERT_TRUE(tagged) << tagged.error().message;
    EXPECT_EQ(read_all(*tagged).size(), count);
    EXPECT_EQ(tagged->complaint(), "");
    const std::size_t half = sound.size() / 2;
    folder.write("a.mp3", sound.substr(0, half) + tags + sound.substr(half));
    EXPECT_NE(complaint_of(path), "") << "there is sound behind it";
  }
  folder.write("a.mp3", whole.substr(0, whole.size() / 2) + tags);
  EXPECT_NE(complaint_of(path).find(" frames it has "), std::string::npos) << complaint_of(path);
}

TEST(SoundFile, ATagBeforeTheSoundDoesNotMakeItMp3) {
  const TempFolder folder;
  for (const int format : {SF_FORMAT_AIFF, SF_FORMAT_WAV, SF_FORMAT_FLAC}) {
    const auto path = write_sound(folder, "a", format | SF_FORMAT_PCM_16, 16000, 1, 1);
    folder.write("a", std::string("ID3\x04\0\0\0\0\0\x05junk\0", 15) + folder.read("a"));
    auto file = SoundFile::open(path);
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_NEAR(static_cast<double>(read_all(*file).size()), kEncoderRate, 10);
  }
}

TEST(SoundFile, TagsWithoutAnEndAreNotFollowed) {
  const TempFolder folder;
  std::string tags;
  for (const bool mp3 : {true, false}) {
    for (int i = 0; i < 16; ++i) tags.append("ID3\x04\0\0\0\0\0\0", 10);
    const auto descriptor = open_file(folder.write("a.mp3", tags + "\xff\xfb\x90\x64"));
    ASSERT_TRUE(descriptor);
    EXPECT_EQ(is_mp3(descriptor->get()), mp3);
  }
}

TEST(SoundFile, ARateThatCannotBeConvertedIsNoSound) {
  const TempFolder folder;
  for (const int rate : {1, 62}) {
    const auto path = write_sound(folder, "a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, rate, 1, 20);
    const auto file = SoundFile::open(path);
    ASSERT_FALSE(file) << rate;
    EXPECT_EQ(file.error().kind, ErrorKind::BadData);
    EXPECT_NE(file.error().message.find(std::to_string(rate) + " samples a second"),
              std::string::npos);
  }
  const auto path = write_sound(folder, "b.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 64, 1, 5);
  auto file = SoundFile::open(path);
  ASSERT_TRUE(file);
  EXPECT_GT(read_all(*file).size(), std::size_t{4 * kEncoderRate});
}

TEST(SoundFile, AHeaderThatTellsOfDaysIsNotBelieved) {
  const TempFolder folder;
  const auto path = write_sound(folder, "a.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 16000, 1, 1);
  std::string bytes = folder.read("a.flac");
  // STREAMINFO: the number of samples is the last 36 bits before the checksum.
  bytes[21] = static_cast<char>(bytes[21] | 0x0f);
  bytes.replace(22, 4, 4, '\xff');
  folder.write("a.flac", bytes);
  const auto file = SoundFile::open(path);
  ASSERT_FALSE(file) << file->duration().count() << " ms";
  EXPECT_EQ(file.error().kind, ErrorKind::BadData);
  EXPECT_NE(file.error().message.find("says that it lasts 1193 hours"), std::string::npos)
      << file.error().message;
}

TEST(SoundFile, AFlacFileFromAPipeIsNotCalledOgg) {
  const TempFolder folder;
  const auto path = write_sound(folder, "a.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 16000, 1, 1);
  std::string bytes = folder.read("a.flac");
  // STREAMINFO, as in the test above: 0 is an unknown number.
  bytes[21] = static_cast<char>(bytes[21] & 0xf0);
  bytes.replace(22, 4, 4, '\0');
  folder.write("a.flac", bytes);
  const std::string why = complaint_of(path);
  EXPECT_NE(why.find("it does not say how long it is; ffmpeg -i OLD NEW mends it"),
            std::string::npos)
      << why;
}

TEST(SoundFile, AnOggFileWithSomethingBehindItIsNotSaidToBeCutOff) {
  const TempFolder folder;
  const int format = SF_FORMAT_OGG | SF_FORMAT_VORBIS;
  const auto path = write_sound(folder, "a.ogg", format, 48000, 1, 1);
  folder.write("a.ogg", folder.read("a.ogg") + "something else");
  const std::string why = complaint_of(path);
  EXPECT_NE(why.find("it was cut off, or something follows; ffmpeg"), std::string::npos) << why;
}

TEST(SoundFile, AFifoIsRefusedAtOnce) {
  const TempFolder folder;
  const auto path = folder.path() / "fifo.wav";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const auto fifo = SoundFile::open(path);
  ASSERT_FALSE(fifo);
  EXPECT_EQ(fifo.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(fifo.error().message.find("it is a pipe, not a file"), std::string::npos);
}

}  // namespace
}  // namespace aucast::voice
