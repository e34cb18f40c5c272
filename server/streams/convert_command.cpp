#include "server/streams/convert_command.h"

#include <charconv>
#include <utility>

#include "common/command_line.h"
#include "common/files.h"
#include "common/sources/openface_table.h"
#include "common/sources/resample.h"
#include "common/text.h"
#include "protocol/limits.h"
#include "protocol/stream_file.h"
#include "server/streams/source_reader.h"

namespace aucast::server {
namespace {

Error usage(std::string message) {
  return {ErrorKind::Usage, std::move(message) + " (try convert --help)"};
}

struct Typed {
  std::vector<std::string> paths;
  std::string keyframe;
  SourceWords source;
  bool mend = false;
  bool help = false;
};

Result<ConvertOptions> options_of(const Typed& typed) {
  ConvertOptions options;
  if (typed.paths.size() != 2) {
    return usage("convert takes two files, IN and OUT, and got " +
                 std::to_string(typed.paths.size()));
  }
  for (const std::string& path : typed.paths) {
    if (path.empty()) return usage("convert: a file's name is empty");
  }
  options.in = typed.paths[0];
  options.out = typed.paths[1];
  if (!typed.keyframe.empty()) {
    const char* end = typed.keyframe.data() + typed.keyframe.size();
    const auto [stopped, error] = std::from_chars(typed.keyframe.data(), end, options.keyframe_ms);
    if (error != std::errc() || stopped != end || options.keyframe_ms < 1 ||
        options.keyframe_ms > protocol::kDurationMsMax) {
      return usage("--keyframe '" + escaped(typed.keyframe) + "' is not a whole number from 1 to " +
                   std::to_string(protocol::kDurationMsMax));
    }
  }
  auto source = read_source_options(typed.source);
  if (!source) return source.error();
  options.source = std::move(*source);
  options.mend = typed.mend;
  if (options.source.recording.all_faces) {
    return usage("convert writes one stream; --face-id all is for serving, name one face");
  }
  return options;
}

/// Reads a stream file that may have been cut off; what was left out is added to `said`.
Result<SourceContent> read_cut_off(const ConvertOptions& options, std::string& said) {
  const auto text = read_file(options.in);
  if (!text) return text.error();
  const auto mended = protocol::mend_stream_text(*text);
  auto stream = protocol::parse_stream_file(mended.text, options.in.string());
  if (!stream) return stream.error();
  if (mended.lines_left_out > 0) {
    said += std::to_string(mended.lines_left_out) + " torn lines at the end left out; ";
  }
  if (options.source.rate) {
    *stream = sources::resample(*stream, *options.source.rate, options.keyframe_ms);
  }
  return SourceContent{std::move(*stream), std::nullopt};
}

std::string sides_sentence(std::size_t uneven) {
  if (uneven == 0) return {};
  return "; it knows no sides: the stronger one of " + std::to_string(uneven) + " keyframes";
}

Result<Converted> convert(const ConvertOptions& options) {
  const SignalOptions& signal = options.source.signal;
  const auto conditioning = conditioning_of(signal);
  if (!conditioning) return conditioning.error();
  std::string said = options.in.string() + ": ";
  const auto content =
      options.mend ? read_cut_off(options, said)
                   : read_source(options.in, options.source, *conditioning, options.keyframe_ms);
  if (!content) return content.error();
  if (!signal.save_profile.empty()) {
    if (measures_neutral(signal) && !content->found) {
      return Error{ErrorKind::Usage,
                   options.in.string() + ": a stream file has no neutral face to measure and save"};
    }
    const auto saved =
        save_profile(signal, content->found ? content->found->neutral : std::nullopt);
    if (!saved) return saved.error();
  }
  std::string text;
  if (content->found) said += sources::found_sentence(*content->found) + "; ";
  said += std::to_string(content->stream.keyframes.size()) + " keyframes, " +
          std::to_string(protocol::media_ms(content->stream, options.keyframe_ms)) + " ms\n";
  if (options.out.extension() == ".csv") {
    auto table = sources::write_openface_table(content->stream, options.keyframe_ms);
    text = std::move(table.text);
    said += options.out.string() + ": a table of OpenFace 2, " + std::to_string(table.rows) +
            " rows" + sides_sentence(table.uneven) + "\n";
  } else {
    text = protocol::format_stream_file(content->stream);
  }
  if (options.out == "-") return Converted{std::move(text), std::move(said)};
  if (auto written = write_file_atomically(options.out, text); !written) return written.error();
  return Converted{{}, std::move(said)};
}

}  // namespace

Result<Converted> run_convert(std::vector<std::string> arguments) {
  CLI::App app;
  Typed typed;
  app.set_help_flag();
  app.add_flag("-h,--help", typed.help);
  app.add_option("FILE", typed.paths);
  app.add_option("--keyframe", typed.keyframe);
  app.add_flag("--mend", typed.mend);
  describe_source_options(app, typed.source);
  if (auto parsed = parse_command_line(app, std::move(arguments)); !parsed) return parsed.error();
  if (typed.help) return Converted{convert_help_text(), {}};
  const auto options = options_of(typed);
  if (!options) return options.error();
  return convert(*options);
}

std::string convert_help_text() {
  return R"(usage: au-transmitter convert [OPTIONS] IN OUT
Writes a recording of an AU recogniser, or a stream file, as a stream file or as a
table, with every change: there is no dead-band here.

  IN                     a stream file, or a table of OpenFace 1 and 2, FACSvatar, Py-Feat,
                         LibreFace or Live Link Face; found out by its columns
  OUT                    the stream file to write; - for stdout; a name in .csv is written
                         as a table of OpenFace 2
  --rate HZ              so many keyframes a second, in straight lines between those there are
  --fps N                pictures a second, for tables without times (Py-Feat) or with wrong ones
  --au-scale S           full intensity in the table: 1, 5, 100 or auto (auto)
  --face-id N            which face of several (the most frequent)
  --min-confidence C     rows less sure are no data, 0 to 1 (0.5): the face holds for 0.5 s,
                         then goes to neutral in 1 s
  --mend                 IN is a stream file that a power cut tore: what is whole of it
  --keyframe MS          time of an untimed keyframe, for --rate (250)
  --neutral SECONDS   --gain LIST   --filter CUTOFF[,BETA]   --distance
  --profile FILE   --save-profile FILE   the signals: see au-transmitter --help

examples:
  au-transmitter convert webcam.csv talk.txt
  au-transmitter convert --rate 10 --fps 30 pyfeat.csv thin.txt
  au-transmitter convert webcam.csv - | head
  au-transmitter convert talk.txt talk.csv
)";
}

}  // namespace aucast::server
