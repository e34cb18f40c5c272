#include "speaker/speaker_app.h"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "common/expressions/expressions.h"
#include "common/files.h"
#include "common/result.h"
#include "common/standard_output.h"
#include "common/text.h"
#include "common/voice/voice_encoder.h"
#include "protocol/codec.h"
#include "protocol/stream_file.h"
#include "speaker/alignment.h"
#include "speaker/captions.h"
#include "speaker/cues.h"
#include "speaker/narration.h"
#include "speaker/output_files.h"
#include "speaker/performance.h"
#include "speaker/script.h"
#include "speaker/speaker_options.h"

namespace aucast::speaker {
namespace {

namespace fs = std::filesystem;

void say(const std::string& message) {
  std::fprintf(stderr, "au-speaker: %s\n", printable(message).c_str());
}

bool from_stdin(const Options& options) {
  return options.text == "-";
}

/// The text's name in messages.
std::string source_of(const Options& options) {
  return from_stdin(options) ? "standard input" : options.text.string();
}

Result<Script> read_script(const Options& options) {
  constexpr std::size_t kTextBytesMax = std::size_t{16} << 20U;
  const auto bytes = from_stdin(options) ? read_standard_input(kTextBytesMax)
                                         : read_file(options.text, kTextBytesMax);
  if (!bytes) return bytes.error();
  return parse_script(*bytes, source_of(options));
}

Result<Expressions> read_expressions(const Options& options) {
  const auto folder = find_data_folder(options.data);
  if (!folder) return folder.error();
  const auto read = load_expressions(*folder / "expressions.toml");
  if (!read) return read.error();
  return sets_of(*read);
}

/// Silence up to the end of the last packet that the voice is sent in, however long those are
/// (60, 40 or 20 ms): sound, face and what is heard end together, to the sample.
void fill_last_packet(Speech& speech) {
  const auto packet = static_cast<std::size_t>(speech.rate) * 120 / 1000;
  speech.samples.resize((speech.samples.size() + packet - 1) / packet * packet);
}

/// The text as a narration reads it; `spoken` as the synthesiser does.
Result<Speech> narrated(const Speech& spoken, const fs::path& file) {
  auto narration = read_narration(file, spoken.length());
  if (!narration) return narration.error();
  if (!narration->complaint.empty()) {
    say(narration->complaint + "; the face is made for what there is");
  }
  // Readings by other synthesisers have 0.33 and more, even in a room that rings; noise, music and
  // silence less than 0.2.
  constexpr float kLikenessMin = 0.25F;
  CarriedOver read = carried_over(spoken, std::move(narration->samples), voice::kEncoderRate);
  if (read.likeness < kLikenessMin) {
    say(at_place(file.string(), "hardly sounds like a reading of the text; is it the right file?"));
  }
  return std::move(read.speech);
}

Result<Speech> speech_of(const Script& script, const Options& options) {
  auto spoken = speak(script.text, options.voice);
  if (!spoken) {
    const Error& error = spoken.error();
    if (error.kind != ErrorKind::BadData) return error;
    return Error{error.kind, at_place(source_of(options), error.message)};
  }
  if (!options.narration.empty()) return narrated(*spoken, options.narration);
  fill_last_packet(*spoken);
  return spoken;
}

/// What au-transmitter would not take is made all the same.
void warn_of(const std::string& name, const Script& script, const Options& options) {
  if (!protocol::is_stream_name(name)) {
    say("au-transmitter will not serve '" + name + "': a stream's name has " +
        protocol::kStreamNameRule + "; choose another one (--name)");
  }
  const protocol::StreamTitle title{script.title, script.title_line};
  const auto wrong = protocol::title_complaint(title, source_of(options));
  if (!wrong.empty()) say(wrong);
}

void sum_up(const OutputFiles& files, Milliseconds length, std::size_t keyframes,
            std::size_t captions) {
  // On stdout it would be one more label.
  std::FILE* const out = files.labels == "/dev/stdout" ? stderr : stdout;
  std::fprintf(out, "%s: %.1f s, %s, %s\n", printable(files.stream.string()).c_str(),
               seconds(length), counted(keyframes, "keyframe").c_str(),
               counted(captions, "caption").c_str());
}

Result<void> run(const Options& options) {
  const auto script = read_script(options);
  if (!script) return script.error();
  const auto expressions = read_expressions(options);
  if (!expressions) return expressions.error();
  const auto cues = check_cues(*script, *expressions, source_of(options));
  if (!cues) return cues;
  const std::string stem = from_stdin(options) ? "speech" : options.text.stem().string();
  const std::string name = options.name.empty() ? stem : options.name;
  warn_of(name, *script, options);
  const OutputFiles files = output_files(options.output.empty() ? fs::path(stem) : options.output,
                                         name, options.narration, options.labels);
  const auto good = check_outputs(files, {options.text, options.narration});
  if (!good) return good;
  const auto speech = speech_of(*script, options);
  if (!speech) return speech.error();
  auto stream = perform(*speech, *script, *expressions, options.gestures);
  stream.title = script->title;
  const auto captions = captions_of(*speech, *script);
  const auto written = write_outputs(files, *speech, stream, captions);
  if (written) sum_up(files, speech->length(), stream.keyframes.size(), captions.size());
  return written;
}

Result<void> print_voices() {
  const auto names = voices();
  if (!names) return names.error();
  for (const std::string& name : *names) std::printf("%s\n", name.c_str());
  return {};
}

Result<void> obey(std::vector<std::string> arguments) {
  Options options;
  const auto rows = option_rows(options);
  const auto typed = sort_arguments(rows, std::move(arguments));
  if (!typed) return typed.error();
  if (auto good = read_words(rows, *typed); !good) return good;
  if (typed->contains("version")) return print_now(version_text());
  if (options.list_voices) return print_voices();
  if (options.text.empty()) return Error{ErrorKind::Usage, "a TEXT is missing; try --help"};
  options.gestures.amount = static_cast<float>(options.gesture_percent) / 100;
  return run(options);
}

}  // namespace

int run_speaker(std::vector<std::string> arguments) {
  ignore_file_size_signal();
  const auto text = asked_text(arguments);
  auto done = text ? print_now(*text) : obey(std::move(arguments));
  if (done) done = print_now();
  if (done) return 0;
  say(done.error().message);
  return exit_code(done.error());
}

}  // namespace aucast::speaker
