#include "speaker/speaker_app.h"

#include <sndfile.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <span>

#include "common/command_line.h"
#include "common/files.h"
#include "common/result.h"
#include "common/text.h"
#include "common/voice/sound_file.h"
#include "common/voice/voice_encoder.h"
#include "protocol/stream_file.h"
#include "speaker/alignment.h"
#include "speaker/captions.h"
#include "speaker/espeak_voice.h"
#include "speaker/performance.h"
#include "speaker/script.h"

namespace aucast::speaker {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription =
    "Makes a face speak: turns a text into speech, a stream file for the face, and captions.\n\n"
    "  au-speaker lecture.txt -o lecture           lecture/lecture.txt, .wav and .vtt\n"
    "  au-speaker lecture.txt --voice talk.wav     the face for a recorded voice\n"
    "  au-transmitter lecture                      serves it\n\n"
    "In the text an empty line ends a paragraph, '# title: ...' names the lecture, other lines "
    "that\n"
    "begin with # are not spoken, and a word in brackets sets the expression until the next "
    "bracket\n"
    "or the end of the paragraph: [smile], [surprise 60] (percent), or AUs, [1,2:40]. Names are "
    "those\n"
    "of expressions.toml.";

struct Options {
  fs::path text;
  fs::path output;
  std::string name;
  fs::path recording;
  fs::path data;
  VoiceOptions voice;
  GestureOptions gestures;
  int gesture_percent = 100;
  fs::path labels;
  bool list_voices = false;
  bool version = false;
};

void bind(CLI::App& app, Options& options) {
  app.add_option("TEXT", options.text, "the text, UTF-8; - reads standard input");
  app.add_option(
      "-o,--output", options.output,
      "folder for the files, made if need be; default: the text's name without its extension");
  app.add_option("--name", options.name, "name of the files; default: the text's, or \"speech\"");
  app.add_option("--voice", options.recording,
                 "a recording of somebody reading TEXT (WAV, FLAC, Ogg, MP3)");
  app.add_option("--language", options.voice.language,
                 "language or voice of espeak-ng, also that of a recorded voice; default en");
  app.add_option("--speed", options.voice.words_per_minute, "words a minute; default 150")
      ->check(CLI::Range(80, 450));
  app.add_option("--pitch", options.voice.pitch, "of the voice, 0 to 99; default 50")
      ->check(CLI::Range(0, 99));
  app.add_option("--gestures", options.gesture_percent,
                 "how much brows and head move, 0 to 200 %; default 100")
      ->check(CLI::Range(0, 200));
  app.add_option("--seed", options.gestures.seed, "seed for the gestures; default 1");
  app.add_option("--labels", options.labels,
                 "writes when each sound is heard, in IPA, as labels for Audacity");
  app.add_option("--data", options.data,
                 "folder with expressions.toml; default: the installed one");
  app.add_flag("--list-voices", options.list_voices, "prints languages and voices");
  app.add_flag("--version", options.version, "prints the version and licence");
}

Result<std::string> read_text(const fs::path& file) {
  constexpr std::size_t kTextBytesMax = std::size_t{16} << 20U;
  return file == "-" ? read_standard_input(kTextBytesMax) : read_file(file, kTextBytesMax);
}

/// 16-bit WAV of mono samples, whole or not at all.
Result<void> write_wav(const fs::path& path, const Speech& speech) {
  const auto temporary = create_temporary_beside(path);
  if (!temporary) return temporary.error();
  SF_INFO info{};
  info.samplerate = speech.rate;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  SNDFILE* const file = sf_open(temporary->c_str(), SFM_WRITE, &info);
  const auto count = static_cast<sf_count_t>(speech.samples.size());
  const bool whole =
      file != nullptr && sf_writef_float(file, speech.samples.data(), count) == count;
  if (sf_close(file) == 0 && whole) return replace_file(*temporary, path);
  std::error_code ignored;
  fs::remove(*temporary, ignored);
  return Error{ErrorKind::Failed, at_place(path.string(), "cannot be written whole")};
}

/// A line for each sound that is no pause: where it begins and ends, in seconds, and its letters.
std::string labels_of(const Speech& speech) {
  std::string text;
  for (std::size_t i = 0; i < speech.phonemes.size(); ++i) {
    const Phoneme& phoneme = speech.phonemes[i];
    if (phoneme.ipa.empty()) continue;
    const Milliseconds end =
        i + 1 < speech.phonemes.size() ? speech.phonemes[i + 1].begin : speech.length();
    std::array<char, 48> times{};
    std::snprintf(times.data(), times.size(), "%.3f\t%.3f\t", seconds(phoneme.begin), seconds(end));
    text += times.data() + phoneme.ipa + "\n";
  }
  return text;
}

Result<Speech> speech_of(const Script& script, const Options& options) {
  auto spoken = speak(script.text, options.voice);
  if (!spoken || options.recording.empty()) return spoken;
  auto file = voice::SoundFile::open(options.recording);
  if (!file) return file.error();
  // What a file says of its length is not believed: it is read a minute at a time.
  constexpr std::size_t kMinute = 60 * std::size_t{voice::kEncoderRate};
  constexpr std::size_t kLongest = 12 * 60 * kMinute;
  std::vector<float> samples;
  for (std::size_t read = kMinute; read == kMinute && samples.size() < kLongest;) {
    const std::size_t before = samples.size();
    samples.resize(before + kMinute);
    read = file->read(std::span(samples).subspan(before));
    samples.resize(before + read);
  }
  Speech speech = carried_over(*spoken, std::move(samples), voice::kEncoderRate);
  const Milliseconds said = spoken->length();
  if (speech.length() < said / 4 || speech.length() > said * 4) {
    return Error{
        ErrorKind::BadData,
        at_place(options.recording.string(),
                 "lasts " + std::to_string(speech.length().count() / 1000) + " s, its text about " +
                     std::to_string(said.count() / 1000) + " s: is it a reading of that text?")};
  }
  return speech;
}

Result<Expressions> expressions_of(const Options& options) {
  const auto folder = find_data_folder(options.data);
  if (!folder) return folder.error();
  const fs::path file = *folder / "expressions.toml";
  const auto bytes = read_file(file);
  if (!bytes) return bytes.error();
  return read_expressions(*bytes, file.string());
}

std::string stream_text(const Script& script, const protocol::StreamFile& stream) {
  std::string text = protocol::format_stream_file(stream);
  if (!script.title.empty()) text = "# title: " + script.title + "\n" + text;
  return text;
}

Result<void> run(const Options& options) {
  const auto bytes = read_text(options.text);
  if (!bytes) return bytes.error();
  const std::string source = options.text == "-" ? "standard input" : options.text.string();
  const auto script = parse_script(*bytes, source);
  if (!script) return script.error();
  const auto expressions = expressions_of(options);
  if (!expressions) return expressions.error();
  if (auto good = check_cues(*script, *expressions, source); !good) return good;
  const auto speech = speech_of(*script, options);
  if (!speech) return speech.error();

  const std::string stem = options.text == "-" ? "speech" : options.text.stem().string();
  const std::string name = options.name.empty() ? stem : options.name;
  const fs::path folder = options.output.empty() ? fs::path(stem) : options.output;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    return Error{ErrorKind::Failed,
                 at_place(folder.string(), "no folder can be made: " + error.message())};
  }
  const fs::path stream_file = folder / (name + ".txt");
  if (options.text != "-" && fs::equivalent(stream_file, options.text, error)) {
    return Error{ErrorKind::Usage, printable(stream_file.string()) +
                                       " is the text itself; choose another folder with -o"};
  }
  if (!options.labels.empty()) {
    if (auto written = write_file_atomically(options.labels, labels_of(*speech)); !written) {
      return written;
    }
  }
  const auto stream = perform(*speech, *script, *expressions, options.gestures);
  if (auto written = write_file_atomically(stream_file, stream_text(*script, stream)); !written) {
    return written;
  }
  const auto captions = captions_of(*speech, *script);
  if (auto written = write_file_atomically(folder / (name + ".vtt"), format_webvtt(captions));
      !written) {
    return written;
  }
  if (options.recording.empty()) {
    if (auto written = write_wav(folder / (name + ".wav"), *speech); !written) return written;
  }
  std::printf("%s: %.1f s, %s, %s\n", printable(stream_file.string()).c_str(),
              seconds(speech->length()), counted(stream.keyframes.size(), "keyframe").c_str(),
              counted(captions.size(), "caption").c_str());
  return {};
}

}  // namespace

int run_speaker(std::vector<std::string> arguments) {
  ignore_file_size_signal();
  CLI::App app{kDescription, "au-speaker"};
  Options options;
  bind(app, options);
  for (const std::string& argument : arguments) {
    if (argument == "--help" || argument == "-h") {
      std::fputs(app.help().c_str(), stdout);
      return 0;
    }
  }
  Result<void> result = parse_command_line(app, std::move(arguments));
  if (result && options.version) {
    std::printf("au-speaker %s (GPL-3.0-or-later, for it speaks with espeak-ng)\n", AUCAST_VERSION);
    return 0;
  }
  if (result && options.list_voices) {
    const auto names = voices();
    if (names) {
      for (const std::string& name : *names) std::printf("%s\n", name.c_str());
      return 0;
    }
    result = names.error();
  } else if (result && options.text.empty()) {
    result = Error{ErrorKind::Usage, "a TEXT is missing; try --help"};
  } else if (result) {
    options.gestures.amount = static_cast<float>(options.gesture_percent) / 100;
    result = run(options);
  }
  if (result) return 0;
  std::fprintf(stderr, "au-speaker: %s\n", result.error().message.c_str());
  return exit_code(result.error());
}

}  // namespace aucast::speaker
