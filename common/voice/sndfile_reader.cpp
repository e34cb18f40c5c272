#include <sndfile.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "common/text.h"
#include "common/voice/container_end.h"
#include "common/voice/sound_reader.h"

namespace aucast::voice {
namespace {

constexpr int kChannelsMax = 64;
constexpr std::size_t kFramesAtOnce = 4096;
/// What libsndfile says of an Ogg file whose end it cannot find, and of FLAC from a pipe.
constexpr sf_count_t kUnknownLength = std::numeric_limits<sf_count_t>::max();

struct CloseFile {
  void operator()(SNDFILE* file) const { sf_close(file); }
};

class SndfileReader final : public SoundReader {
 public:
  SndfileReader(std::unique_ptr<SNDFILE, CloseFile> file, const SF_INFO& info, std::string missing)
      : file_(std::move(file)),
        info_(info),
        missing_(std::move(missing)),
        frames_(kFramesAtOnce * static_cast<std::size_t>(info.channels)) {}

  [[nodiscard]] int rate() const override { return info_.samplerate; }
  [[nodiscard]] std::int64_t count() const override { return info_.frames; }

  [[nodiscard]] std::size_t read(std::span<float> samples) override {
    std::size_t done = 0;
    while (done < samples.size()) {
      const std::size_t wanted = std::min(kFramesAtOnce, samples.size() - done);
      const auto count = static_cast<std::size_t>(
          sf_readf_float(file_.get(), frames_.data(), static_cast<sf_count_t>(wanted)));
      average(samples.subspan(done, count));
      done += count;
      done_ += static_cast<std::int64_t>(count);
      if (count < wanted) {
        complain();
        break;
      }
    }
    return done;
  }

  [[nodiscard]] std::string complaint() const override { return complaint_; }
  [[nodiscard]] bool damaged() const override { return damaged_; }

 private:
  void average(std::span<float> samples) const {
    const auto channels = static_cast<std::size_t>(info_.channels);
    const float* frame = frames_.data();
    for (float& sample : samples) {
      float sum = 0;
      for (std::size_t i = 0; i < channels; ++i) sum += *frame++;
      sample = sum / static_cast<float>(channels);
    }
  }

  /// At the end. libsndfile tells an error only once, and of a FLAC file that was cut between two
  /// of its frames not at all.
  void complain() {
    if (sf_error(file_.get()) != 0) {
      complaint_ = sf_strerror(file_.get());
      damaged_ = true;
    }
    if (complaint_.empty()) complaint_ = missing_;
    if (complaint_.empty() && done_ < info_.frames) {
      complaint_ = "of " + counted(static_cast<std::uint64_t>(info_.frames), "sample") +
                   " it has " + std::to_string(done_);
    }
  }

  std::unique_ptr<SNDFILE, CloseFile> file_;
  SF_INFO info_;
  std::string missing_;
  std::string complaint_;
  bool damaged_ = false;
  std::int64_t done_ = 0;  ///< how many samples were read
  std::vector<float> frames_;
};

}  // namespace

Result<std::unique_ptr<SoundReader>> open_sndfile(Descriptor opened) {
  const auto wrong = [](std::string why) { return Error{ErrorKind::BadData, std::move(why)}; };
  const ContainerEnd end = container_end(opened.get());
  SF_INFO info{};
  std::unique_ptr<SNDFILE, CloseFile> file(sf_open_fd(opened.release(), SFM_READ, &info, SF_TRUE));
  if (!file) return wrong(sf_strerror(nullptr));
  if (info.channels < 1 || info.channels > kChannelsMax || info.frames < 1) {
    return wrong("it has no samples");
  }
  if (end.within_page) {
    return wrong(
        "its end is no whole page of Ogg: it was cut off, or something follows; "
        "ffmpeg -i OLD -c copy NEW mends it");
  }
  if (info.frames == kUnknownLength) {
    return wrong("it does not say how long it is; ffmpeg -i OLD NEW mends it");
  }
  return std::unique_ptr<SoundReader>(
      std::make_unique<SndfileReader>(std::move(file), info, end.missing));
}

}  // namespace aucast::voice
