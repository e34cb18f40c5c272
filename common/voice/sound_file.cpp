#include "common/voice/sound_file.h"

#include <samplerate.h>

#include <array>
#include <utility>

#include "common/check.h"
#include "common/files.h"
#include "common/text.h"
#include "common/voice/sound_reader.h"
#include "common/voice/voice_encoder.h"

namespace aucast::voice {
namespace {

constexpr std::size_t kSamplesAtOnce = 4096;
/// A header that tells of more has lied: who serves the sound would make a face for all that time.
constexpr std::int64_t kHoursMax = 24;

struct DeleteConverter {
  void operator()(SRC_STATE* state) const { src_delete(state); }
};

}  // namespace

struct SoundFile::State {
  std::string name;
  std::string conversion_error;  ///< empty: none
  std::unique_ptr<SoundReader> reader;
  std::unique_ptr<SRC_STATE, DeleteConverter> converter;
  std::array<float, kSamplesAtOnce> samples{};

  /// The next samples at the file's own rate; libsamplerate calls it.
  static long next_block(void* self, float** block) {
    auto& state = *static_cast<State*>(self);
    *block = state.samples.data();
    return static_cast<long>(state.reader->read(state.samples));
  }
};

SoundFile::SoundFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
SoundFile::~SoundFile() = default;
SoundFile::SoundFile(SoundFile&&) noexcept = default;
SoundFile& SoundFile::operator=(SoundFile&&) noexcept = default;

Result<SoundFile> SoundFile::open(const std::filesystem::path& path) {
  const auto wrong = [&path](const std::string& why) {
    return Error{ErrorKind::BadData, at_place(path.string(), why)};
  };
  auto file = open_file(path);
  if (!file) return file.error();
  const bool mp3 = is_mp3(file->get());
  auto reader = mp3 ? open_mp3(*std::move(file)) : open_sndfile(*std::move(file));
  if (!reader) {
    return wrong("no sound that can be read (WAV, FLAC, Ogg Vorbis, Ogg Opus, MP3): " +
                 reader.error().message);
  }
  const int rate = (*reader)->rate();
  if (src_is_valid_ratio(static_cast<double>(kEncoderRate) / rate) == 0) {
    return wrong(std::to_string(rate) + " samples a second are no sound");
  }
  if ((*reader)->count() / rate >= kHoursMax * 3600) {
    return wrong("says that it lasts " + std::to_string((*reader)->count() / rate / 3600) +
                 " hours, of which fewer than " + std::to_string(kHoursMax) +
                 " are read; write it again, or cut it");
  }
  auto state = std::make_unique<State>();
  state->name = path.string();
  state->reader = std::move(*reader);
  int error = 0;
  state->converter.reset(
      src_callback_new(State::next_block, SRC_SINC_MEDIUM_QUALITY, 1, &error, state.get()));
  AUCAST_CHECK(state->converter != nullptr);
  return SoundFile(std::move(state));
}

std::size_t SoundFile::read(std::span<float> samples) {
  const double ratio = static_cast<double>(kEncoderRate) / state_->reader->rate();
  std::size_t done = 0;
  while (done < samples.size()) {
    const long count =
        src_callback_read(state_->converter.get(), ratio, static_cast<long>(samples.size() - done),
                          samples.data() + done);
    if (count < 0) {
      state_->conversion_error = src_strerror(src_error(state_->converter.get()));
    }
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

std::string SoundFile::complaint() const {
  const std::string& failed = state_->conversion_error;
  const std::string why = failed.empty() ? state_->reader->complaint() : failed;
  if (why.empty()) return {};
  return at_place(state_->name, "the sound breaks off before its end: " + why);
}

bool SoundFile::damaged() const {
  return !state_->conversion_error.empty() || state_->reader->damaged();
}

Milliseconds SoundFile::duration() const {
  return Milliseconds(state_->reader->count() * 1000 / state_->reader->rate());
}

}  // namespace aucast::voice
