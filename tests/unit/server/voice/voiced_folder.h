#pragma once

#include <gtest/gtest.h>
#include <sndfile.h>

#include <filesystem>
#include <string>
#include <vector>

#include "common/voice/voice_encoder.h"
#include "server/voice/voice_file.h"
#include "server/voice/voice_summary.h"
#include "tests/support/quiet_log.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {

/// A folder with faces and the sound files beside them.
class VoicedFolder : public ::testing::Test {
 protected:
  std::filesystem::path write_wav(const std::string& name, const std::vector<float>& samples) {
    const auto path = folder_.path() / name;
    SF_INFO info{};
    info.samplerate = voice::kEncoderRate;
    info.channels = 1;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SNDFILE* const file = sf_open(path.c_str(), SFM_WRITE, &info);
    EXPECT_NE(file, nullptr);
    sf_write_float(file, samples.data(), static_cast<sf_count_t>(samples.size()));
    sf_close(file);
    return path;
  }
  std::filesystem::path write_face(const std::string& name, int seconds) {
    std::string text = "# title: A talk\nBeg_Stream\n";
    for (int i = 0; i < seconds; ++i) text += i % 2 == 0 ? "12:50;1000\n" : "12:10;1000\n";
    return folder_.write(name, text + "End_Stream\n");
  }
  [[nodiscard]] std::vector<protocol::VoicePacket> encoded(const VoiceFile& file) const {
    const auto summary = summarise_voice(file, {});
    EXPECT_TRUE(summary);
    return summary->packets;
  }

  const test::QuietLog quiet_;
  const test::TempFolder folder_;
};

}  // namespace aucast::server
