#include "speaker/speaker_app.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "common/files.h"
#include "common/manual.h"
#include "common/options.h"
#include "common/overwriting.h"
#include "common/result.h"
#include "common/sound_name.h"
#include "common/standard_output.h"
#include "common/temporary_file.h"
#include "common/text.h"
#include "common/voice/voice_encoder.h"
#include "common/voice/wav_bytes.h"
#include "protocol/codec.h"
#include "protocol/stream_file.h"
#include "speaker/alignment.h"
#include "speaker/captions.h"
#include "speaker/espeak_voice.h"
#include "speaker/narration.h"
#include "speaker/performance.h"
#include "speaker/script.h"

namespace aucast::speaker {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path text;
  fs::path output;
  std::string name;
  fs::path narration;
  fs::path data;
  VoiceOptions voice;
  GestureOptions gestures;
  int gesture_percent = 100;
  fs::path labels;
  bool list_voices = false;
};

std::vector<OptionRow> rows_of(Options& options) {
  using Where = OptionRow::Where;
  std::vector<OptionRow> rows{
      {.option = {"text", "TEXT"},
       .text = "a text file, UTF-8; - for stdin",
       .value = word(options.text),
       .heading = "Files",
       .where = Where::Positional},
      {.option = {"output", "DIR"},
       .text = "folder for the files (TEXT without its extension)",
       .more = "The folder for the files, which is made if need be. Default: the name of TEXT "
               "without its extension.",
       .value = word(options.output),
       .letter = 'o'},
      {.option = {"name", "NAME"},
       .text = "name of the files (that of TEXT; stdin: \"speech\")",
       .value = word(options.name)},
      {.option = {"voice", "FILE"},
       .text = "a narration: TEXT read aloud (WAV, FLAC, Ogg, MP3)",
       .more = "A narration, which is somebody reading TEXT (WAV, FLAC, Ogg, MP3), of at most "
               "three hours. It becomes the voice of the stream.",
       .value = word(options.narration)},
      {.option = {"labels", "FILE"},
       .text = "write the times of the sounds (IPA), for Audacity",
       .value = word(options.labels)},
      {.option = {"data", "DIR"},
       .text = "folder with expressions.toml (the installed one)",
       .value = word(options.data)},
      {.option = {"language", "NAME", "en"},
       .text = "language or voice of espeak-ng (en)",
       .more = "A language or a voice of espeak-ng, also that of a recorded voice.",
       .value = word(options.voice.language),
       .heading = "Speech"},
      {.option = {"speed", "N", "150"},
       .text = "words a minute, 80 to 450 (150)",
       .value = whole(options.voice.words_per_minute, 80, 450)},
      {.option = {"pitch", "N", "50"},
       .text = "pitch of the voice, 0 to 99 (50)",
       .value = whole(options.voice.pitch, 0, 99)},
      {.option = {"list-voices"},
       .text = "print languages and voices",
       .value = flag(options.list_voices)},
      {.option = {"gestures", "N", "100"},
       .text = "how much brows and head move, 0 to 200 % (100)",
       .value = whole(options.gesture_percent, 0, 200),
       .heading = "Face"},
      {.option = {"seed", "N", "1"},
       .text = "seed for the gestures (1)",
       .value = whole(options.gestures.seed, 0, std::numeric_limits<std::int64_t>::max())}};
  auto help = help_rows();
  help.front().heading = "Other";
  append(rows, std::move(help));
  return rows;
}

CommandPage speaker_page() {
  Options described;
  return {.program = "au-speaker",
          .usage = {"au-speaker [OPTIONS] TEXT"},
          .about =
              "Makes a face speak: turns a text into speech, a stream file for the face, and\n"
              "captions. In parentheses: defaults.\n",
          .rows = unbound(rows_of(described)),
          .notes =
              "In TEXT an empty line ends a paragraph, '# title: ...' names the lecture, other\n"
              "lines that begin with # are not spoken, and a word in brackets sets the\n"
              "expression until the next bracket or the end of the paragraph: [smile],\n"
              "[surprise 60] (percent), or AUs, [1,2:40]. Names are those of expressions.toml.\n",
          .examples = {"au-speaker lecture.txt -o lecture        # lecture/lecture.txt, .wav, .vtt",
                       "au-speaker lecture.txt --voice talk.wav  # the face for a recorded voice",
                       "au-transmitter lecture                   # serves it"}};
}

std::string manual_page() {
  ManualPage page("au-speaker", AUCAST_VERSION, "makes a face speak a text");
  page.section("DESCRIPTION");
  page.command(speaker_page());
  page.section("SEE ALSO");
  page.paragraph("au-transmitter(1), face-player(1)");
  return page.text();
}

/// The text that the arguments ask for instead of speech.
std::optional<std::string> asked_text(const std::vector<std::string>& arguments) {
  // For the build, which installs both.
  if (arguments == std::vector<std::string>{"--help-man"}) return manual_page();
  if (auto script = asked_completion(arguments, {speaker_page()})) return script;
  for (const std::string& argument : arguments) {
    if (argument == "--help" || argument == "-h") return help_text(speaker_page());
  }
  return std::nullopt;
}

Result<std::string> read_text(const fs::path& file) {
  constexpr std::size_t kTextBytesMax = std::size_t{16} << 20U;
  return file == "-" ? read_standard_input(kTextBytesMax) : read_file(file, kTextBytesMax);
}

/// A 16-bit WAV file of mono samples.
void write_wav(const Speech& speech, std::ostream& file) {
  constexpr std::size_t kPortion = 65'536;
  std::string bytes = voice::wav_head(speech.samples.size(), speech.rate);
  for (const float sample : speech.samples) {
    voice::append_wav_sample(std::lrint(sample * 32767), bytes);
    if (bytes.size() < kPortion) continue;
    file << bytes;
    bytes.clear();
  }
  file << bytes;
}

/// Files that belong together: they get their names when all of them have been written.
class Files {
 public:
  Result<void> add(const fs::path& path, const std::function<void(std::ostream&)>& write) {
    auto temporary = TemporaryFile::beside(path);
    if (!temporary) return temporary.error();
    std::ofstream file(temporary->path(), std::ios::binary);
    write(file);
    file.close();
    if (!file) {
      return Error{ErrorKind::Failed,
                   at_place(path.string(), "cannot be written whole: " + system_reason(errno))};
    }
    files_.emplace_back(std::move(*temporary), path);
    return {};
  }
  Result<void> add(const fs::path& path, const std::string& text) {
    return add(path, [&text](std::ostream& file) { file << text; });
  }
  Result<void> finish() {
    for (auto& [temporary, path] : files_) {
      if (auto replaced = temporary.replace(path); !replaced) return replaced;
    }
    return {};
  }

 private:
  std::vector<std::pair<TemporaryFile, fs::path>> files_;
};

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

/// Silence up to the end of the last packet that the voice is sent in, however long those are
/// (60, 40 or 20 ms): sound, face and what is heard end together, to the sample.
void fill_last_packet(Speech& speech) {
  const auto packet = static_cast<std::size_t>(speech.rate) * 120 / 1000;
  speech.samples.resize((speech.samples.size() + packet - 1) / packet * packet);
}

void say(const std::string& message) {
  std::fprintf(stderr, "au-speaker: %s\n", printable(message).c_str());
}

Result<Speech> speech_of(const Script& script, const Options& options, const std::string& source) {
  auto spoken = speak(script.text, options.voice);
  if (!spoken) {
    const Error& error = spoken.error();
    if (error.kind != ErrorKind::BadData) return error;
    return Error{error.kind, at_place(source, error.message)};
  }
  if (options.narration.empty()) {
    fill_last_packet(*spoken);
    return spoken;
  }
  auto narration = read_narration(options.narration, spoken->length());
  if (!narration) return narration.error();
  if (!narration->complaint.empty()) {
    say(narration->complaint + "; the face is made for what there is");
  }
  // Readings by other synthesisers have 0.33 and more, even in a room that rings; noise, music and
  // silence less than 0.2.
  constexpr float kLikenessMin = 0.25F;
  CarriedOver read = carried_over(*spoken, std::move(narration->samples), voice::kEncoderRate);
  if (read.likeness < kLikenessMin) {
    say(at_place(options.narration.string(),
                 "hardly sounds like a reading of the text; is it the right file?"));
  }
  return std::move(read.speech);
}

Result<Expressions> expressions_of(const Options& options) {
  const auto folder = find_data_folder(options.data);
  if (!folder) return folder.error();
  const auto read = load_expressions(*folder / "expressions.toml");
  if (!read) return read.error();
  return sets_of(*read);
}

/// The WAV file of the stream's voice; empty: the narration is beside the stream already.
fs::path sound_file(const fs::path& stream_file, const fs::path& narration) {
  const auto beside = sound_beside(stream_file);
  std::error_code none;
  if (beside && fs::equivalent(*beside, narration, none)) return {};
  return fs::path(stream_file).replace_extension(".wav");
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

Result<void> run(const Options& options) {
  const auto bytes = read_text(options.text);
  if (!bytes) return bytes.error();
  const std::string source = options.text == "-" ? "standard input" : options.text.string();
  const auto script = parse_script(*bytes, source);
  if (!script) return script.error();
  const auto expressions = expressions_of(options);
  if (!expressions) return expressions.error();
  if (auto good = check_cues(*script, *expressions, source); !good) return good;
  const std::string stem = options.text == "-" ? "speech" : options.text.stem().string();
  const std::string name = options.name.empty() ? stem : options.name;
  if (!protocol::is_stream_name(name)) {
    say("au-transmitter will not serve '" + name + "': a stream's name has " +
        protocol::kStreamNameRule + "; choose another one (--name)");
  }
  const protocol::StreamTitle title{script->title, script->title_line};
  if (const auto wrong = protocol::title_complaint(title, source); !wrong.empty()) say(wrong);
  const fs::path folder = options.output.empty() ? fs::path(stem) : options.output;
  const fs::path stream_file = folder / (name + ".txt");
  const fs::path caption_file = folder / (name + ".vtt");
  const fs::path voice_file = sound_file(stream_file, options.narration);
  const std::vector<fs::path> outputs{stream_file, caption_file, voice_file, options.labels};
  if (auto good = check_not_read(outputs, {options.text, options.narration}); !good) return good;
  if (auto good = check_distinct(outputs); !good) return good;
  const auto speech = speech_of(*script, options, source);
  if (!speech) return speech.error();
  if (auto made = make_folder(folder); !made) return made;
  auto stream = perform(*speech, *script, *expressions, options.gestures);
  stream.title = script->title;
  const auto captions = captions_of(*speech, *script);
  Files files;
  auto written = files.add(stream_file, protocol::format_stream_file(stream));
  if (written) written = files.add(caption_file, format_webvtt(captions));
  if (written && !voice_file.empty()) {
    written = files.add(voice_file, [&](std::ostream& file) { write_wav(*speech, file); });
  }
  if (written) written = files.finish();
  if (written && !options.labels.empty()) {
    written = write_file_atomically(options.labels, labels_of(*speech));
  }
  if (!written) return written;
  std::printf("%s: %.1f s, %s, %s\n", printable(stream_file.string()).c_str(),
              seconds(speech->length()), counted(stream.keyframes.size(), "keyframe").c_str(),
              counted(captions.size(), "caption").c_str());
  return {};
}

Result<void> print_voices() {
  const auto names = voices();
  if (!names) return names.error();
  for (const std::string& name : *names) std::printf("%s\n", name.c_str());
  return {};
}

Result<void> obey(std::vector<std::string> arguments, Options& options) {
  const auto rows = rows_of(options);
  const auto typed = sort_arguments(rows, std::move(arguments));
  if (!typed) return typed.error();
  if (auto good = read_words(rows, *typed); !good) return good;
  if (typed->contains("version")) {
    std::printf("au-speaker %s (GPL-3.0-or-later, as it links espeak-ng)\n", AUCAST_VERSION);
    return {};
  }
  if (options.list_voices) return print_voices();
  if (options.text.empty()) return Error{ErrorKind::Usage, "a TEXT is missing; try --help"};
  options.gestures.amount = static_cast<float>(options.gesture_percent) / 100;
  return run(options);
}

int report(const Error& error) {
  say(error.message);
  return exit_code(error);
}

}  // namespace

int run_speaker(std::vector<std::string> arguments) {
  ignore_file_size_signal();
  if (const auto text = asked_text(arguments)) {
    if (const auto printed = print_now(*text); !printed) return report(printed.error());
    return 0;
  }
  Options options;
  auto done = obey(std::move(arguments), options);
  if (done) done = print_now();
  return done ? 0 : report(done.error());
}

}  // namespace aucast::speaker
