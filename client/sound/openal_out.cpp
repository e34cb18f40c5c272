#include "client/sound/openal_out.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <dlfcn.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <utility>
#include <vector>

#include "client/sound/pcm.h"
#include "client/sound/sound_track.h"

namespace aucast::sound {
namespace {

/// How often the device takes sound from the mixer; its report of what has been heard leaps by as
/// much.
constexpr ALCint kUpdatesPerSecond = 100;

struct CloseDevice {
  void operator()(ALCdevice* device) const { alcCloseDevice(device); }
};
struct DestroyContext {
  void operator()(ALCcontext* context) const {
    alcMakeContextCurrent(nullptr);
    alcDestroyContext(context);
  }
};
using Device = std::unique_ptr<ALCdevice, CloseDevice>;
using Context = std::unique_ptr<ALCcontext, DestroyContext>;

/// The type of ALSA's error handler. OpenAL loads ALSA.
using AlsaHandler = void (*)(const char* file, int line, const char* function, int error,
                             const char* format, ...);
void hear_no_alsa(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/,
                  const char* /*format*/, ...) {}

void quieten_alsa() {
  if (static bool done = false; std::exchange(done, true)) return;
  void* const alsa = ::dlopen("libasound.so.2", RTLD_LAZY);
  if (alsa == nullptr) return;
  using SetHandler = int (*)(AlsaHandler);
  const auto set = reinterpret_cast<SetHandler>(::dlsym(alsa, "snd_lib_error_set_handler"));
  if (set != nullptr) set(hear_no_alsa);
}

class OpenAlOut final : public SoundOut {
 public:
  OpenAlOut(Device device, Context context)
      : device_(std::move(device)), context_(std::move(context)) {
    alGenSources(1, &source_);
    // At the listener's ears, and nothing done to it.
    alSourcei(source_, AL_SOURCE_RELATIVE, AL_TRUE);
    alSourcef(source_, AL_ROLLOFF_FACTOR, 0);
    if (alIsExtensionPresent("AL_SOFT_source_latency") == AL_TRUE) {
      offset_and_latency_ =
          reinterpret_cast<LPALGETSOURCEI64VSOFT>(alGetProcAddress("alGetSourcei64vSOFT"));
    }
    tells_loss_ = alcIsExtensionPresent(device_.get(), "ALC_EXT_disconnect") == ALC_TRUE;
  }

  ~OpenAlOut() override {
    alSourceStop(source_);
    alSourcei(source_, AL_BUFFER, 0);
    alDeleteSources(1, &source_);
    for (const Queued& queued : queued_) alDeleteBuffers(1, &queued.buffer);
    for (const ALuint buffer : free_) alDeleteBuffers(1, &buffer);
  }

  void write(std::span<const float> samples) override {
    if (samples.empty()) return;
    // A source that has run out of buffers calls all it has played, those queued later too.
    const bool stands = state() != AL_PLAYING;
    collect();
    alGetError();  // of what came before
    ALuint buffer = 0;
    if (free_.empty()) {
      alGenBuffers(1, &buffer);
    } else {
      buffer = free_.back();
      free_.pop_back();
    }
    const std::vector<std::int16_t> pcm = pcm_of(samples);
    alBufferData(buffer, AL_FORMAT_MONO16, pcm.data(),
                 static_cast<ALsizei>(pcm.size() * sizeof(std::int16_t)), kRate);
    alSourceQueueBuffers(source_, 1, &buffer);
    // A buffer that is not played must not be counted as heard: the face follows that.
    if (alGetError() != AL_NO_ERROR) {
      if (buffer != 0) alDeleteBuffers(1, &buffer);
      failed_ = true;
      return;
    }
    queued_.push_back({buffer, static_cast<std::int64_t>(samples.size())});
    if (stands) alSourcePlay(source_);
  }

  std::int64_t heard() override {
    collect();
    if (state() != AL_PLAYING) return done_;
    if (offset_and_latency_ == nullptr) {
      ALint offset = 0;
      alGetSourcei(source_, AL_SAMPLE_OFFSET, &offset);
      return done_ + offset;
    }
    std::array<ALint64SOFT, 2> told{};  // samples in 32.32 fixed point, then nanoseconds
    offset_and_latency_(source_, AL_SAMPLE_OFFSET_LATENCY_SOFT, told.data());
    return done_ + (told[0] >> 32) - told[1] * kSamplesPerMs / 1'000'000;
  }

  bool lost() override {
    if (failed_) return true;
    if (!tells_loss_) return false;
    ALCint connected = ALC_TRUE;
    alcGetIntegerv(device_.get(), ALC_CONNECTED, 1, &connected);
    return connected == ALC_FALSE;
  }

 private:
  struct Queued {
    ALuint buffer = 0;
    std::int64_t samples = 0;
  };

  [[nodiscard]] ALint state() const {
    ALint state = 0;
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    return state;
  }

  /// Takes back the buffers that have been played.
  void collect() {
    ALint count = 0;
    alGetSourcei(source_, AL_BUFFERS_PROCESSED, &count);
    for (; count > 0 && !queued_.empty(); --count) {
      ALuint buffer = 0;
      alSourceUnqueueBuffers(source_, 1, &buffer);
      done_ += queued_.front().samples;
      free_.push_back(queued_.front().buffer);
      queued_.pop_front();
    }
  }

  Device device_;
  Context context_;
  ALuint source_ = 0;
  LPALGETSOURCEI64VSOFT offset_and_latency_ = nullptr;
  bool tells_loss_ = false;
  std::deque<Queued> queued_;
  std::vector<ALuint> free_;
  std::int64_t done_ = 0;  ///< samples of the buffers taken back
  bool failed_ = false;    ///< it took no more sound
};

std::string named(const std::vector<std::string>& devices) {
  std::string text;
  for (const std::string& device : devices) text += (text.empty() ? "" : ", ") + device;
  return text;
}

}  // namespace

void quieten_openal() {
  constexpr int kKeep = 0;
  ::setenv("ALSOFT_LOGLEVEL", "0", kKeep);
}

std::vector<std::string> sound_devices() {
  quieten_alsa();
  std::vector<std::string> devices;
  const bool all = alcIsExtensionPresent(nullptr, "ALC_ENUMERATE_ALL_EXT") == ALC_TRUE;
  const ALCchar* name =
      alcGetString(nullptr, all ? ALC_ALL_DEVICES_SPECIFIER : ALC_DEVICE_SPECIFIER);
  // Names with a 0 behind each, and one more behind all.
  for (; name != nullptr && *name != '\0'; name += std::strlen(name) + 1) {
    devices.emplace_back(name);
  }
  return devices;
}

Result<std::unique_ptr<SoundOut>> open_sound_device(const std::string& name) {
  quieten_alsa();
  Device device(alcOpenDevice(name.empty() ? nullptr : name.c_str()));
  if (!device) {
    const std::string devices = named(sound_devices());
    if (devices.empty()) return Error{ErrorKind::Failed, "there is no sound device"};
    return Error{ErrorKind::Failed, (name.empty() ? "the sound device" : "sound device " + name) +
                                        " cannot be opened; there are: " + devices};
  }
  const std::array<ALCint, 5> wishes{ALC_FREQUENCY, kRate, ALC_REFRESH, kUpdatesPerSecond, 0};
  Context context(alcCreateContext(device.get(), wishes.data()));
  if (!context || alcMakeContextCurrent(context.get()) != ALC_TRUE) {
    return Error{ErrorKind::Failed, "the sound device does not play"};
  }
  return std::unique_ptr<SoundOut>(
      std::make_unique<OpenAlOut>(std::move(device), std::move(context)));
}

}  // namespace aucast::sound
