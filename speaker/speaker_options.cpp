#include "speaker/speaker_options.h"

#include <cstdint>
#include <limits>

#include "common/manual.h"
#include "common/standard_output.h"
#include "protocol/limits.h"

namespace aucast::speaker {
namespace {

/// A name and no path: the files would lie beside the folder of --output, or in another one.
Complaint read_name(const std::string& word, std::string& out) {
  if (word.find('/') != std::string::npos) {
    return "has a '/', which no file's name has; --output names the folder";
  }
  out = word;
  return std::nullopt;
}

CommandPage speaker_page() {
  Options described;
  return {.program = "au-speaker",
          .usage = {"au-speaker [OPTIONS] TEXT"},
          .about =
              "Makes a face speak: turns a text into speech, a stream file for the face, and\n"
              "captions. In parentheses: defaults.\n",
          .rows = unbound(option_rows(described)),
          .notes =
              "In TEXT an empty line ends a paragraph, '# title: ...' names the lecture, other\n"
              "lines that begin with # are not spoken, and a word in brackets sets the\n"
              "expression until the next bracket or the end of the paragraph: [smile],\n"
              "[surprise 60] (percent), or AUs, [1,2:40]. Names are [smile] and those of\n"
              "expressions.toml.\n",
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

}  // namespace

std::vector<OptionRow> option_rows(Options& options) {
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
       .value = parsed(OptionValue::Kind::Word, read_name, options.name)},
      {.option = {"voice", "FILE"},
       .text = "a recording of TEXT read aloud (WAV, FLAC, Ogg, MP3)",
       .more = "A narration in place of espeak-ng's voice: a recording of somebody who reads TEXT "
               "(WAV, FLAC, Ogg, MP3), of at most three hours. It becomes the voice of the stream.",
       .value = word(options.narration)},
      {.option = {"labels", "FILE"},
       .text = "write the times of phonemes (Audacity); - for stdout",
       .more = "Writes when each phoneme is heard, in IPA letters, as labels for Audacity, with - "
               "to stdout.",
       .value = parsed(OptionValue::Kind::Word, read_output_path, options.labels)},
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
       .text = "print what --language takes",
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

std::optional<std::string> asked_text(const std::vector<std::string>& arguments) {
  // For the build, which installs both.
  if (arguments == std::vector<std::string>{"--help-man"}) return manual_page();
  if (auto script = asked_completion(arguments, {speaker_page()})) return script;
  for (const std::string& argument : arguments) {
    if (argument == "--help" || argument == "-h") return help_text(speaker_page());
  }
  return std::nullopt;
}

std::string version_text() {
  return "au-speaker " AUCAST_VERSION " (protocol " + std::to_string(protocol::kProtocolVersion) +
         "), GPL-3.0-or-later, as it links espeak-ng and FFTW\n";
}

}  // namespace aucast::speaker
