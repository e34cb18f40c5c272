#include "client/sound/file_track.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include "client/sound/pcm.h"
#include "common/text.h"
#include "common/voice/sound_file.h"
#include "common/voice/voice_encoder.h"

namespace aucast::sound {
namespace {

/// How many samples of ours there are to one of the file.
constexpr int kPhases = kRate / voice::kEncoderRate;
constexpr int kReach = 12;
constexpr int kTaps = 2 * kReach;
using Filter = std::array<std::array<float, kTaps>, kPhases>;

/// A filter for values between two samples of the file: a sinc with a Hann window, kReach samples
/// to each side. Phase 0 is the sample itself.
Filter make_filter() {
  Filter filter{};
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int tap = 0; tap < kTaps; ++tap) {
      const double x = tap - (kReach - 1) - static_cast<double>(phase) / kPhases;
      const double sinc = x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
      const double window = 0.5 + 0.5 * std::cos(std::numbers::pi * x / kReach);
      filter[static_cast<std::size_t>(phase)][static_cast<std::size_t>(tap)] =
          static_cast<float>(sinc * window);
    }
  }
  return filter;
}

constexpr std::size_t kBlockSamples = voice::kEncoderRate;

std::string too_long(const std::filesystem::path& path, const std::string& consequence) {
  return at_place(path.string(), "lasts more than the " + std::to_string(FileTrack::kHoursMax) +
                                     " hours that are played with a face; " + consequence);
}

Result<voice::SoundFile> open_short(const std::filesystem::path& path) {
  auto file = voice::SoundFile::open(path);
  if (file && file->duration() > std::chrono::hours(FileTrack::kHoursMax)) {
    return Error{ErrorKind::BadData, too_long(path, "cut it")};
  }
  return file;
}

}  // namespace

Result<std::unique_ptr<FileTrack>> FileTrack::open(const std::filesystem::path& path,
                                                   const std::function<bool()>& stop) {
  auto file = open_short(path);
  if (!file) return file.error();
  std::unique_ptr<FileTrack> track(new FileTrack(path));
  track->complaint_ = track->read_rest(*file, stop);
  track->take_news();
  return track;
}

Result<std::unique_ptr<FileTrack>> FileTrack::begin(const std::filesystem::path& path) {
  auto opened = open_short(path);
  if (!opened) return opened.error();
  std::unique_ptr<FileTrack> track(new FileTrack(path));
  // Shared, since a std::function is copied.
  const auto file = std::make_shared<voice::SoundFile>(*std::move(opened));
  const bool more = track->read_block(*file);
  track->take_news();
  if (!more) {
    track->complaint_ = file->complaint();
    return track;
  }
  const auto started = track->reading_.start([self = track.get(), file] {
    return self->read_rest(*file, [self] { return self->stop_.stop_requested(); });
  });
  if (!started) return started.error();
  return track;
}

FileTrack::~FileTrack() {
  stop_.request_stop();
}

/// Reads the next second. Returns false if it was the last one.
bool FileTrack::read_block(voice::SoundFile& file) {
  std::vector<float> samples(kBlockSamples);
  samples.resize(file.read(samples));
  const bool more = samples.size() == kBlockSamples;
  Block block = pcm_of(samples);
  news_.with([&](std::vector<Block>& news) { news.push_back(std::move(block)); });
  return more;
}

/// Returns the file's complaint.
std::string FileTrack::read_rest(voice::SoundFile& file, const std::function<bool()>& stop) {
  // A header may tell of less than there is.
  constexpr int kBlocksMax = kHoursMax * 3600;
  for (int i = 0; i < kBlocksMax && !stop(); ++i) {
    if (!read_block(file)) return file.complaint();
  }
  return stop() ? std::string() : too_long(path_, "the rest is not played");
}

void FileTrack::take_news() {
  auto blocks = news_.with([](std::vector<Block>& news) { return std::exchange(news, {}); });
  for (Block& block : blocks) append(std::move(block));
}

void FileTrack::append(Block block) {
  count_ += static_cast<std::int64_t>(block.size());
  blocks_.push_back(std::move(block));
}

std::string FileTrack::take_complaint() {
  if (auto said = reading_.take()) complaint_ = *std::move(said);
  return std::exchange(complaint_, {});
}

void FileTrack::read(std::int64_t begin, std::span<float> samples) {
  static const Filter filter = make_filter();
  take_news();
  for (float& out : samples) {
    const std::int64_t at = begin++;
    const std::int64_t whole = at >= 0 ? at / kPhases : -((-at + kPhases - 1) / kPhases);
    const auto phase = static_cast<std::size_t>(at - whole * kPhases);
    float sum = 0;
    for (std::size_t tap = 0; tap < kTaps; ++tap) {
      sum += filter[phase][tap] * this->at(whole - (kReach - 1) + static_cast<std::int64_t>(tap));
    }
    out = sum / kPcmWhole;
  }
}

float FileTrack::at(std::int64_t sample) const {
  if (sample < 0 || sample >= count_) return 0;
  const auto index = static_cast<std::size_t>(sample);
  return blocks_[index / kBlockSamples][index % kBlockSamples];
}

std::int64_t FileTrack::end() const {
  return count_ * kPhases;
}

}  // namespace aucast::sound
