#include "common/voice/sound_file.h"

#include <samplerate.h>
#include <sndfile.h>

#include <array>
#include <utility>
#include <vector>

#include "common/check.h"
#include "common/files.h"
#include "common/text.h"
#include "common/voice/voice_encoder.h"

namespace aucast::voice {
namespace {

constexpr int kChannelsMax = 64;
constexpr std::size_t kFramesAtOnce = 4096;
/// A header that tells of more has lied: who serves the sound would make a face for all that time.
constexpr sf_count_t kHoursMax = 24;

struct CloseFile {
  void operator()(SNDFILE* file) const { sf_close(file); }
};
struct DeleteConverter {
  void operator()(SRC_STATE* state) const { src_delete(state); }
};

}  // namespace

struct SoundFile::State {
  std::string name;
  std::string complaint;
  std::unique_ptr<SNDFILE, CloseFile> file;
  SF_INFO info{};
  std::unique_ptr<SRC_STATE, DeleteConverter> converter;
  std::vector<float> frames;
  std::array<float, kFramesAtOnce> mono{};

  /// The next samples at the file's own rate; libsamplerate calls it.
  static long next_block(void* self, float** block) {
    auto& state = *static_cast<State*>(self);
    const auto channels = static_cast<std::size_t>(state.info.channels);
    const sf_count_t count = sf_readf_float(state.file.get(), state.frames.data(),
                                            static_cast<sf_count_t>(kFramesAtOnce));
    for (std::size_t frame = 0; frame < static_cast<std::size_t>(count); ++frame) {
      float sum = 0;
      for (std::size_t i = 0; i < channels; ++i) sum += state.frames[frame * channels + i];
      state.mono[frame] = sum / static_cast<float>(channels);
    }
    if (count < static_cast<sf_count_t>(kFramesAtOnce) && sf_error(state.file.get()) != 0) {
      state.complaint = sf_strerror(state.file.get());
    }
    *block = state.mono.data();
    return static_cast<long>(count);
  }
};

SoundFile::SoundFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
SoundFile::~SoundFile() = default;
SoundFile::SoundFile(SoundFile&&) noexcept = default;
SoundFile& SoundFile::operator=(SoundFile&&) noexcept = default;

Result<SoundFile> SoundFile::open(const std::filesystem::path& path) {
  const auto descriptor = open_file(path);
  if (!descriptor) return descriptor.error();
  auto state = std::make_unique<State>();
  state->file.reset(sf_open_fd(*descriptor, SFM_READ, &state->info, SF_TRUE));
  const SF_INFO& info = state->info;
  if (!state->file || info.channels < 1 || info.channels > kChannelsMax || info.frames < 1) {
    const std::string why = state->file ? "it has no samples" : std::string(sf_strerror(nullptr));
    return Error{
        ErrorKind::BadData,
        at_place(path.string(),
                 "no sound that can be read (WAV, FLAC, Ogg Vorbis, Ogg Opus, MP3): " + why)};
  }
  if (src_is_valid_ratio(static_cast<double>(kEncoderRate) / info.samplerate) == 0) {
    return Error{ErrorKind::BadData, at_place(path.string(), std::to_string(info.samplerate) +
                                                                 " samples a second are no sound")};
  }
  if (info.frames / info.samplerate >= kHoursMax * 3600) {
    return Error{
        ErrorKind::BadData,
        at_place(path.string(), "says that it lasts " +
                                    std::to_string(info.frames / info.samplerate / 3600) +
                                    " hours, of which fewer than " + std::to_string(kHoursMax) +
                                    " are read; write it again, or cut it")};
  }
  state->name = path.string();
  state->frames.resize(kFramesAtOnce * static_cast<std::size_t>(info.channels));
  int error = 0;
  state->converter.reset(
      src_callback_new(State::next_block, SRC_SINC_MEDIUM_QUALITY, 1, &error, state.get()));
  AUCAST_CHECK(state->converter != nullptr);
  return SoundFile(std::move(state));
}

std::size_t SoundFile::read(std::span<float> samples) {
  const double ratio = static_cast<double>(kEncoderRate) / state_->info.samplerate;
  std::size_t done = 0;
  while (done < samples.size()) {
    const long count =
        src_callback_read(state_->converter.get(), ratio, static_cast<long>(samples.size() - done),
                          samples.data() + done);
    if (count < 0) state_->complaint = src_strerror(src_error(state_->converter.get()));
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

std::string SoundFile::complaint() const {
  if (state_->complaint.empty()) return {};
  return at_place(state_->name, "the sound breaks off before its end: " + state_->complaint);
}

Milliseconds SoundFile::duration() const {
  return Milliseconds(state_->info.frames * 1000 / state_->info.samplerate);
}

}  // namespace aucast::voice
