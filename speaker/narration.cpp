#include "speaker/narration.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "common/text.h"
#include "common/voice/sound_file.h"
#include "common/voice/voice_encoder.h"

namespace aucast::speaker {
namespace {

/// How many times longer or shorter than the synthesiser a reader may be.
constexpr int kOffMax = 4;

std::string whole_seconds(Milliseconds time) {
  return std::to_string(time.count() / 1000) + " s";
}

}  // namespace

Result<Narration> read_narration(const std::filesystem::path& path, Milliseconds said,
                                 Milliseconds longest) {
  const auto wrong = [&path](const std::string& why) {
    return Error{ErrorKind::BadData, at_place(path.string(), why)};
  };
  const auto no_reading = [&](const std::string& length) {
    return wrong("lasts " + length + ", its text about " + whole_seconds(said) +
                 ": is it a reading of that text?");
  };
  auto file = voice::SoundFile::open(path);
  if (!file) return file.error();
  // What a file says of its length is not believed: it is read a minute at a time.
  constexpr std::size_t kMinute = 60 * std::size_t{voice::kEncoderRate};
  const Milliseconds most = std::min(longest, said * kOffMax);
  const auto samples_max = static_cast<std::size_t>(most.count()) * voice::kEncoderSamplesPerMs;
  std::vector<float> samples;
  for (std::size_t read = kMinute; read == kMinute && samples.size() <= samples_max;) {
    const std::size_t before = samples.size();
    samples.resize(before + kMinute);
    read = file->read(std::span(samples).subspan(before));
    samples.resize(before + read);
  }
  std::string complaint = file->complaint();
  if (file->damaged()) {
    return Error{ErrorKind::BadData, complaint + " (ffmpeg -i OLD NEW keeps what can be decoded)"};
  }
  if (samples.size() > samples_max) {
    if (most < longest) return no_reading("more than " + whole_seconds(most));
    return wrong("lasts more than " + whole_seconds(longest) +
                 ", the longest that is read; cut it and its text into parts");
  }
  const Milliseconds length(samples.size() / voice::kEncoderSamplesPerMs);
  if (length < said / kOffMax) {
    if (!complaint.empty()) return Error{ErrorKind::BadData, std::move(complaint)};
    return no_reading(whole_seconds(length));
  }
  return Narration{std::move(samples), std::move(complaint)};
}

}  // namespace aucast::speaker
