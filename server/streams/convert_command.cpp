#include "server/streams/convert_command.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "common/files.h"
#include "common/film_name.h"
#include "common/memory.h"
#include "common/overwriting.h"
#include "common/sources/found_report.h"
#include "common/sources/openface_table.h"
#include "common/sources/source_reader.h"
#include "common/text.h"
#include "protocol/limits.h"
#include "protocol/stream_file.h"
#include "server/settings/source_options.h"
#include "server/streams/film_source.h"
#include "server/streams/resampling.h"

namespace aucast::server {
namespace {

Error convert_usage(std::string message) {
  return {ErrorKind::Usage, std::move(message) + " (try convert --help)"};
}

struct ConvertOptions {
  std::filesystem::path in;
  std::filesystem::path out;                ///< "-": stdout
  std::vector<std::filesystem::path> more;  ///< with `to`: OUT and these are sources too
  std::filesystem::path to;                 ///< a folder; empty: there is OUT
  std::uint32_t keyframe_ms = protocol::kDefaultKeyframeTime.count();
  SourceOptions source;
  bool mend = false;  ///< the input is a stream file that may have been cut off
};

std::vector<OptionRow> rows_of(ConvertOptions& options) {
  using Where = OptionRow::Where;
  std::vector<OptionRow> rows{
      {.option = {"in", "IN"},
       .text = "a stream file, a table of a recogniser, or a film",
       .more = "A stream file, or a table of OpenFace 1 or 2, FACSvatar, Py-Feat, LibreFace, "
               "FaceReader, iMotions, Live Link Face or MediaPipe, recognised by its columns; or a "
               "film of a face, recognised by its extension (.mp4, .mov, .mkv, .webm, .avi and "
               "others).",
       .value = word(options.in),
       .where = Where::Positional},
      {.option = {"out", "OUT"},
       .text = "the stream file; - for stdout; NAME.csv: OpenFace 2",
       .more = "The stream file to write, or - for stdout. If its name ends in .csv, it is written "
               "as a table of OpenFace 2.",
       .value = word(options.out),
       .where = Where::Positional},
      {.option = {"more", "IN..."},
       .more = "With --to, more sources.",
       .value = words(options.more),
       .where = Where::Positional},
      {.option = {"to", "DIR"},
       .text = "write each IN to DIR/NAME.txt, in place of OUT",
       .more = "Then every IN is a source, and becomes a stream file of its name in this folder.",
       .value = word(options.to)},
      {.option = {"mend"},
       .text = "if IN was cut off, convert what is intact",
       .more = "IN is a stream file truncated by a power cut. What is intact of it is converted to "
               "OUT.",
       .value = flag(options.mend)},
      {.option = {"keyframe", "MS", "250"},
       .text = "how long keyframes without a time last (250)",
       .value = whole(options.keyframe_ms, 1, protocol::kKeyframeTimeMsMax)}};
  append(rows, recording_rows(options.source));
  append(rows, signal_rows(options.source.signal));
  std::erase_if(rows, [](const OptionRow& row) { return row.option.name == "dead-band"; });
  for (OptionRow& row : rows) {
    if (row.option.name != "face-id") continue;
    row.text = "which of several faces";
    row.more =
        "Which of several faces. Without it: the most frequent one of a recording, the clearest "
        "one of a film. Faces of films are counted from 0 as they are first seen.";
  }
  rows.push_back(help_rows().front());
  return rows;
}

Result<void> validate(const ConvertOptions& options) {
  if (options.in.empty() || (options.out.empty() && options.to.empty()))
    return convert_usage("convert needs two files, IN and OUT, or --to DIR and files");
  if (options.to.empty() && !options.more.empty()) {
    return convert_usage("convert takes two files, IN and OUT, or more with --to DIR");
  }
  if (options.source.recording.all_faces) {
    return convert_usage("convert writes one stream; --face-id all is for serving, name one face");
  }
  return {};
}

/// Reads a stream file that may have been cut off; adds to `said` how much was left out.
Result<sources::SourceContent> read_cut_off(const ConvertOptions& options, std::string& said) {
  const auto text = sources::read_text(options.in);
  if (!text) return text.error();
  if (auto fits = sources::check_room(*text, options.in); !fits) return fits.error();
  const auto mended = protocol::mend_stream_text(*text);
  auto stream = protocol::parse_stream_file(mended.text, sources::name_of(options.in));
  if (!stream) return stream.error();
  if (mended.lines_left_out > 0) {
    said += counted(mended.lines_left_out, "torn line") + " at the end left out; ";
  }
  return sources::SourceContent{std::move(*stream), std::nullopt};
}

std::string sides_sentence(std::size_t uneven) {
  if (uneven == 0) return {};
  return ", which has no sides: in " + counted(uneven, "keyframe") + " the stronger one was taken";
}

/// Reads the faces in a film.
Result<sources::SourceContent> read_seen(const ConvertOptions& options,
                                         const sources::ConditioningSettings& conditioning,
                                         const SayProgress& say) {
  const std::string name = options.in.filename().string();
  const auto on_progress = [&](const camera::FilmProgress& progress) {
    std::string text = name + ": " + std::to_string(static_cast<int>(progress.seconds)) + " s";
    if (progress.whole) {
      const double part = std::min(progress.seconds / *progress.whole, 1.0);
      text += ", " + std::to_string(static_cast<int>(100 * part)) + " %";
    }
    say(text);
  };
  const auto text =
      film_text(options.in, options.source,
                say ? on_progress : std::function<void(const camera::FilmProgress&)>());
  if (!text) return text.error();
  if (auto fits = sources::check_room(*text, options.in); !fits) return fits.error();
  auto contents = sources::parse_streams(*text, options.in.string(), options.source.recording,
                                         conditioning_for(options.in, conditioning));
  if (!contents) return contents.error();
  return std::move(contents->front());
}

Result<sources::SourceContent> read_any(const ConvertOptions& options,
                                        const sources::ConditioningSettings& conditioning,
                                        const SayProgress& say, std::string& said) {
  if (options.mend) return read_cut_off(options, said);
  if (is_film(options.in)) return read_seen(options, conditioning, say);
  return sources::read_source(
      options.in, {options.source.recording, std::nullopt, conditioning, options.keyframe_ms});
}

/// What was found in the source, and how long its stream is.
std::string found_report(const ConvertOptions& options, const sources::SourceContent& content) {
  std::string said;
  if (content.found) said += sources::found_sentence(*content.found) + "; ";
  if (const std::string unused = options_of_recordings(options.source);
      !content.found && !unused.empty()) {
    said += "a stream file, not changed by " + unused + "; ";
  }
  return said + counted(content.stream.keyframes.size(), "keyframe") + ", " +
         std::to_string(protocol::media_ms(content.stream, options.keyframe_ms)) + " ms\n";
}

/// No file may be written over what is read, nor over another one.
Result<void> check_files(std::vector<std::filesystem::path> made,
                         const std::vector<std::filesystem::path>& sources,
                         const std::filesystem::path& profile) {
  made.push_back(profile);
  auto kept = check_not_read(made, sources);
  if (kept) kept = check_distinct(made);
  if (!kept) return convert_usage(kept.error().message);
  return {};
}

/// Writes the stream as OUT wants it. `said`: the report so far.
Result<Converted> write_out(const ConvertOptions& options, const protocol::StreamFile& stream,
                            std::string said) {
  std::string text;
  if (file_ending(options.out) == ".csv") {
    const std::uint64_t ms = protocol::media_ms(stream, options.keyframe_ms);
    auto can = check_memory(options.out, ms / sources::kRowMsMax * sources::kWholeKeyframeBytes,
                            "convert a shorter stream");
    if (!can) return can.error();
    auto table = sources::write_openface_table(stream, options.keyframe_ms);
    text = std::move(table.text);
    said += at_place(options.out.string(), "a table of OpenFace 2, ") + counted(table.rows, "row") +
            sides_sentence(table.uneven) + "\n";
  } else {
    text = protocol::format_stream_file(stream);
  }
  if (options.out == "-") return Converted{std::move(text), std::move(said)};
  if (auto written = write_file_atomically(options.out, text); !written) return written.error();
  return Converted{{}, std::move(said)};
}

Result<Converted> convert(const ConvertOptions& options, const SayProgress& say) {
  const SignalOptions& signal = options.source.signal;
  const auto conditioning = conditioning_of(signal);
  if (!conditioning) return conditioning.error();
  std::string said = at_place(options.in.string(), "");
  auto content = read_any(options, *conditioning, say, said);
  if (!content) return content.error();
  if (const auto rate = options.source.rate) {
    auto done = resample(content->stream, *rate, options.keyframe_ms, options.in);
    if (!done) return done.error();
  }
  if (!signal.save_profile.empty() && measures_neutral(signal) && !content->found) {
    return Error{
        ErrorKind::Usage,
        at_place(options.in.string(), "a stream file has no neutral face to measure and save")};
  }
  said += found_report(options, *content);
  auto converted = write_out(options, content->stream, std::move(said));
  if (!converted || signal.save_profile.empty()) return converted;
  // Last: what could not be converted leaves the profile as it was.
  const auto saved = save_profile(signal.save_profile, *conditioning,
                                  content->found ? content->found->neutral : std::nullopt);
  if (!saved) return Error{saved.error().kind, converted->said + saved.error().message};
  return converted;
}

/// Converts each source to a stream file of its name in the folder.
Result<Converted> convert_each(const ConvertOptions& options, const SayProgress& say) {
  std::vector<std::filesystem::path> sources{options.in};
  if (!options.out.empty()) sources.push_back(options.out);
  sources.insert(sources.end(), options.more.begin(), options.more.end());
  const SignalOptions& signal = options.source.signal;
  if (sources.size() > 1 && !signal.save_profile.empty() && measures_neutral(signal)) {
    return convert_usage("--save-profile with --neutral takes one source, and there are " +
                         std::to_string(sources.size()));
  }
  std::set<std::string> names;
  for (const std::filesystem::path& source : sources) {
    if (!names.insert(source.stem().string()).second) {
      return convert_usage(at_place(source.string(), "another source is called '" +
                                                         printable(source.stem().string()) +
                                                         "' too; convert one of them alone"));
    }
  }
  const auto made_of = [&](const std::filesystem::path& source) {
    return options.to / (source.stem().string() + ".txt");
  };
  std::vector<std::filesystem::path> made;
  for (const std::filesystem::path& source : sources) made.push_back(made_of(source));
  if (auto kept = check_files(made, sources, signal.save_profile); !kept) return kept.error();
  Converted all;
  for (const std::filesystem::path& source : sources) {
    ConvertOptions one = options;
    one.in = source;
    one.out = made_of(source);
    auto converted = convert(one, say);
    if (!converted) {
      return Error{converted.error().kind, all.said + converted.error().message};
    }
    all.said += converted->said;
  }
  return all;
}

}  // namespace

Result<Converted> run_convert(std::vector<std::string> arguments, const SayProgress& say) {
  ConvertOptions options;
  const std::vector<OptionRow> rows = rows_of(options);
  const auto typed = sort_arguments(rows, std::move(arguments));
  if (!typed) return typed.error();
  if (typed->contains("help")) return Converted{help_text(convert_page()), {}};
  if (auto read = read_words(rows, *typed); !read) return read.error();
  if (auto valid = validate(options); !valid) return valid.error();
  if (!options.to.empty()) return convert_each(options, say);
  const auto& profile = options.source.signal.save_profile;
  if (auto kept = check_files({options.out}, {options.in}, profile); !kept) return kept.error();
  return convert(options, say);
}

CommandPage convert_page() {
  ConvertOptions described;
  return {.program = "au-transmitter",
          .command = "convert",
          .usage = {"au-transmitter convert [OPTIONS] IN OUT",
                    "au-transmitter convert [OPTIONS] --to DIR IN..."},
          .about =
              "Converts a recording, a film or a stream file to a stream file or an OpenFace\n"
              "table. Every change of an intensity is written, however small: the dead band of\n"
              "a profile is not applied.\n"
              "In parentheses: defaults.\n",
          .rows = unbound(rows_of(described)),
          .examples = {"au-transmitter convert webcam.csv talk.txt",
                       "au-transmitter convert --rate 10 --fps 30 pyfeat.csv thin.txt",
                       "au-transmitter convert lecture.mp4 lecture.txt"}};
}

}  // namespace aucast::server
