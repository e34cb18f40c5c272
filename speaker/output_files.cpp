#include "speaker/output_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <system_error>

#include "common/files.h"
#include "common/files_together.h"
#include "common/overwriting.h"
#include "common/sound_name.h"
#include "common/text.h"
#include "common/voice/wav_bytes.h"

namespace aucast::speaker {
namespace {

namespace fs = std::filesystem;

/// A 16-bit WAV file of mono samples.
void write_wav(const Speech& speech, const FilesTogether::Append& append) {
  constexpr std::size_t kPortion = 65'536;
  std::string bytes = voice::wav_head(speech.samples.size(), speech.rate);
  for (const float sample : speech.samples) {
    voice::append_wav_sample(std::lrint(sample * 32767), bytes);
    if (bytes.size() < kPortion) continue;
    append(bytes);
    bytes.clear();
  }
  append(bytes);
}

/// Whether the folder of `file` is not there yet, but will be when that of `stream` is made.
bool made_with(const fs::path& stream, const fs::path& file) {
  std::error_code none;
  const fs::path folder = whole_path(file).parent_path();
  if (fs::is_directory(folder, none)) return false;
  const fs::path whole = whole_path(stream);
  return std::mismatch(folder.begin(), folder.end(), whole.begin(), whole.end()).first ==
         folder.end();
}

Result<void> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return {};
  // Such as TEXT itself, if its name has no extension.
  std::error_code unknown;
  const std::string why = fs::exists(folder, unknown) ? "a file has this name" : error.message();
  return Error{ErrorKind::Failed, at_place(folder.string(), "no folder can be made: " + why +
                                                                "; name another one (--output)")};
}

}  // namespace

OutputFiles output_files(const fs::path& folder, const std::string& name, const fs::path& narration,
                         const fs::path& labels) {
  OutputFiles files{folder / (name + ".txt"), folder / (name + ".vtt"), folder / (name + ".wav"),
                    labels};
  const auto beside = sound_beside(files.stream);
  std::error_code none;
  if (beside && fs::equivalent(*beside, narration, none)) files.voice.clear();
  return files;
}

Result<void> check_outputs(const OutputFiles& files, const std::vector<fs::path>& inputs) {
  const std::vector<fs::path> outputs{files.stream, files.captions, files.voice, files.labels};
  if (auto good = check_not_read(outputs, inputs); !good) return good;
  if (auto good = check_distinct(outputs); !good) return good;
  for (const fs::path& output : outputs) {
    if (output.empty() || made_with(files.stream, output)) continue;
    if (auto good = check_writable(output); !good) return good;
  }
  return {};
}

Result<void> write_outputs(const OutputFiles& files, const Speech& speech,
                           const protocol::StreamFile& stream,
                           const std::vector<TimedCaption>& captions) {
  if (auto made = make_folder(files.stream.parent_path()); !made) return made;
  FilesTogether together;
  auto written = together.add(files.stream, protocol::format_stream_file(stream));
  if (written) written = together.add(files.captions, format_webvtt(captions));
  if (written && !files.voice.empty()) {
    written = together.add(files.voice, [&](const auto& append) { write_wav(speech, append); });
  }
  if (written && !files.labels.empty()) written = together.add(files.labels, labels_of(speech));
  return written ? together.finish() : written;
}

std::string labels_of(const Speech& speech) {
  std::string text;
  for (std::size_t i = 0; i < speech.phonemes.size(); ++i) {
    const Phoneme& phoneme = speech.phonemes[i];
    if (phoneme.ipa.empty()) continue;
    std::array<char, 48> times{};
    std::snprintf(times.data(), times.size(), "%.3f\t%.3f\t", seconds(phoneme.begin),
                  seconds(speech.phoneme_end(i)));
    text += times.data() + phoneme.ipa + "\n";
  }
  return text;
}

}  // namespace aucast::speaker
