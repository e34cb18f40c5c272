#include "server/voice/voice_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "common/text.h"

namespace aucast::server {
namespace {

/// How many samples are read at a time; encoding them takes a hundredth of a second.
constexpr std::size_t kSamplesAtOnce = 2 * voice::kEncoderRate;

Error with_remedy(Error error) {
  error.message += " (--no-voice serves the face without it)";
  return error;
}

}  // namespace

Result<VoiceFile> find_voice_file(const std::filesystem::path& path, Milliseconds begin) {
  const auto sound = voice::SoundFile::open(path);
  if (!sound) return with_remedy(sound.error());
  if (sound->duration() == Milliseconds::zero()) {
    return with_remedy(
        {ErrorKind::BadData, at_place(path.string(), "it has less than a millisecond of sound")});
  }
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    return with_remedy({ErrorKind::Unreadable,
                        at_place(path.string(), "cannot be read: " + system_reason(errno))});
  }
  return VoiceFile{path,
                   begin,
                   sound->duration(),
                   status.st_dev,
                   status.st_ino,
                   status.st_size,
                   status.st_mtim.tv_sec * 1'000'000'000 + status.st_mtim.tv_nsec};
}

Result<VoiceReader> VoiceReader::open(const VoiceFile& file, const voice::VoiceSettings& settings) {
  auto sound = voice::SoundFile::open(file.path);
  if (!sound) return sound.error();
  return VoiceReader(std::move(*sound), settings, file.begin);
}

VoiceReader::VoiceReader(voice::SoundFile sound, const voice::VoiceSettings& settings,
                         Milliseconds begin)
    : sound_(std::move(sound)),
      encoder_(settings, std::max(begin, Milliseconds::zero())),
      samples_(kSamplesAtOnce),
      skipped_(static_cast<std::size_t>(std::max<Milliseconds::rep>(-begin.count(), 0)) *
               voice::kEncoderSamplesPerMs) {}

bool VoiceReader::read(std::vector<protocol::VoicePacket>& packets) {
  const std::size_t count = sound_.read(samples_);
  const std::size_t skip = std::min(skipped_, count);
  skipped_ -= skip;
  encoder_.add(std::span(samples_).subspan(skip, count - skip), packets);
  end_ = encoder_.end();
  if (count == samples_.size()) return true;
  encoder_.finish(packets);
  return false;
}

std::uint32_t voice_kbits(const voice::VoiceSettings& settings) {
  constexpr std::string_view kAround = "{a }";
  const auto frame_ms = static_cast<double>(settings.frame.count());
  const double data = settings.bits_per_second / 1000.0 * 4 / 3;
  const double around = static_cast<double>(kAround.size() * 8) / frame_ms;
  return static_cast<std::uint32_t>(std::ceil(data + around));
}

Result<std::uint32_t> face_kbits(std::uint32_t max_kbits, const voice::VoiceSettings& settings,
                                 const std::filesystem::path& source) {
  /// With less than this a face is a slide show.
  constexpr std::uint32_t kFaceKbitsLeast = 2;
  if (max_kbits == 0) return 0U;
  const std::uint32_t voice = voice_kbits(settings);
  if (max_kbits >= voice + kFaceKbitsLeast) return max_kbits - voice;
  return Error{
      ErrorKind::Usage,
      at_place(source.string(), "the voice takes " + std::to_string(voice) +
                                    " kbit/s of --max-bitrate " + std::to_string(max_kbits) +
                                    ", which leaves too little for the face; ask for at least " +
                                    std::to_string(voice + kFaceKbitsLeast) +
                                    ", a lower --voice-rate or --no-voice")};
}

}  // namespace aucast::server
