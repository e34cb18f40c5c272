#include "client/app/option_rows.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "client/gallery/section_names.h"
#include "client/playback/source_playback.h"
#include "client/view/video_encoder.h"
#include "common/number_of.h"
#include "common/standard_output.h"
#include "common/text.h"

namespace aucast::app {
namespace {

using Kind = OptionValue::Kind;
using Where = OptionRow::Where;

constexpr int kSizeMax = view::kVideoSideMax;
constexpr double kSecondsMax = 86'400;
constexpr int kDelayMaxMs = playback::BufferOptions::kDelayMax.count();
constexpr int kSpeedMaxMs = playback::SourcePlayback::kSpeedMax.count();

std::string text_of_range(std::size_t low, std::size_t high) {
  return std::to_string(low) + " to " + std::to_string(high);
}

template <typename Number>
bool read_whole(std::string_view text, Number low, Number high, Number& out) {
  const auto value = number_of<Number>(text);
  if (!value || *value < low || *value > high) return false;
  out = *value;
  return true;
}

Complaint read_size(const std::string& word, OutputOptions& output) {
  const auto parts = split(word, 'x');
  output.size_given = parts.size() == 2 && read_whole(parts[0], 1, kSizeMax, output.width) &&
                      read_whole(parts[1], 1, kSizeMax, output.height);
  if (output.size_given) return std::nullopt;
  return "is not WIDTHxHEIGHT, each 1 to " + std::to_string(kSizeMax) + ", such as 800x600";
}

Complaint read_background(const std::string& word, OutputOptions& output) {
  output.transparent = word == "none";
  output.background.reset();
  if (output.transparent) return std::nullopt;
  std::uint32_t rgb = 0;
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, rgb, 16);
  if (word.size() != 6 || read.ec != std::errc() || read.ptr != end) {
    return "is not RRGGBB, such as 808080, and not none";
  }
  output.background = rgb;
  return std::nullopt;
}

Complaint read_layers(const std::string& word, view::Layers& out) {
  auto layers = view::parse_layers(word);
  if (!layers) return "is not a list of layers: " + layers.error().message;
  out = *layers;
  return std::nullopt;
}

Complaint read_muscle(const std::string& word,
                      std::vector<std::pair<std::string, float>>& muscles) {
  const std::size_t equals = word.find('=');
  const auto value = equals == std::string::npos
                         ? std::nullopt
                         : number_of<float>(std::string_view(word).substr(equals + 1));
  if (!value || !std::isfinite(*value)) return "is not NAME=VALUE, such as jaw=1.5";
  muscles.emplace_back(word.substr(0, equals), *value);
  return std::nullopt;
}

Complaint read_sections(const std::string& word, std::vector<std::string>& sections) {
  for (const std::string_view part : split(word, ',')) {
    std::string section;
    if (const auto wrong =
            one_of(section, {gallery::kSectionNames.begin(), gallery::kSectionNames.end()})
                .read(std::string(part))) {
      return wrong;
    }
    sections.push_back(std::move(section));
  }
  return std::nullopt;
}

/// SEED[:INTERVAL_MS[:CLOSING_MS]]
Complaint read_blink(const std::string& word, std::optional<playback::BlinkOptions>& out) {
  using Blink = playback::BlinkOptions;
  Blink blink;
  const auto parts = split(word, ':');
  constexpr auto kSeedMax = std::numeric_limits<std::uint64_t>::max();
  const bool good =
      parts.size() <= 3 && read_whole(parts[0], std::uint64_t{0}, kSeedMax, blink.seed) &&
      (parts.size() < 2 ||
       read_whole(parts[1], Blink::kIntervalMinMs, Blink::kIntervalMaxMs, blink.interval_ms)) &&
      (parts.size() < 3 ||
       read_whole(parts[2], Blink::kClosingMinMs, Blink::kClosingMaxMs, blink.closing_ms)) &&
      blink.closing_ms * 6 <= blink.interval_ms;
  if (!good) {
    return "is not SEED[:INTERVAL[:CLOSING]]: a number, then milliseconds, " +
           text_of_range(Blink::kIntervalMinMs, Blink::kIntervalMaxMs) +
           " from blink to blink and " + text_of_range(Blink::kClosingMinMs, Blink::kClosingMaxMs) +
           ", at most a sixth of that, to close the lids";
  }
  out = blink;
  return std::nullopt;
}

Complaint read_idle(const std::string& word, PlaybackOptions& playback) {
  playback.idle_seed = number_of<std::uint64_t>(word);
  if (!playback.idle_seed) return "is not a whole number";
  if (!playback.blink) playback.blink = playback::BlinkOptions{*playback.idle_seed};
  return std::nullopt;
}

Complaint read_buffer(const std::string& word, playback::BufferOptions& buffers) {
  constexpr std::size_t kSetsMax = playback::BufferOptions::kSetsMax;
  if (read_whole(word, std::size_t{1}, kSetsMax, buffers.receiver_capacity)) {
    return std::nullopt;
  }
  int time_ms = 0;
  const bool timed =
      word.ends_with("ms") &&
      read_whole(std::string_view(word).substr(0, word.size() - 2), 0, kDelayMaxMs, time_ms);
  if (word != "auto" && !timed) {
    return "is neither auto, nor a time of 0ms to " + std::to_string(kDelayMaxMs) + "ms, nor " +
           text_of_range(1, kSetsMax) + " sets";
  }
  buffers.receiver_capacity = playback::kReceiverSetsByTime;
  buffers.by_time = true;
  if (timed) {
    buffers.live_delay = Milliseconds(time_ms);
    buffers.adapt = false;
  }
  return std::nullopt;
}

Complaint read_live_delay(const std::string& word, playback::BufferOptions& buffers) {
  buffers.adapt = false;
  return whole(buffers.live_delay, 0, kDelayMaxMs).read(word);
}

std::vector<OptionRow> face_rows(FaceOptions& face) {
  return {
      {.option = {"face", "NAME", "default"},
       .text = "name of a face (\"default\"), or the folder of one",
       .more = "The name of a face in data/faces, or the folder of any face.",
       .value = word(face.face),
       .heading = "Face"},
      {.option = {"mixer", "MIXER", "maximum"},
       .text = "for AUs sharing a muscle: maximum, average (maximum)",
       .more = "How contractions of one muscle by several AUs are combined: maximum or average.",
       .value = one_of<face::Mixer>(
           face.mixer, {{"maximum", face::Mixer::Maximum}, {"average", face::Mixer::Average}})},
  };
}

std::vector<OptionRow> rules_rows(FaceOptions& face) {
  return {
      {.option = {"rules", "RULES", "facs"},
       .text = "facs, kumar2010, none or FILE (facs)",
       .more = "The co-occurrence rules: facs, kumar2010 (as published), none, or a file.",
       .value = word(face.rules)},
      {.option = {"data", "DIR"},
       .text = "folder with faces, rules and streams",
       .more = "The folder with faces, rules and streams, if not the installed one.",
       .value = word(face.data)},
  };
}

std::vector<OptionRow> animation_rows(PlaybackOptions& playback) {
  using playback::Interpolation;
  return {
      {.option = {"speed", "MS"},
       .text = "how long keyframes without a time last (250)",
       .more = "How long keyframes without a time of their own last, 1 to 1000 ms. Without this "
               "option: 250 ms, or what the server says.",
       .value = whole(playback.speed, 1, kSpeedMaxMs),
       .heading = "Animation"},
      {.option = {"interpolation", "KIND", "linear"},
       .text = "linear or cosine (linear)",
       .more = "Between keyframes: linear or cosine.",
       .value = one_of<Interpolation>(playback.interpolation, {{"linear", Interpolation::Linear},
                                                               {"cosine", Interpolation::Cosine}})},
      {.option = {"blink", "SEED[:EVERY[:CLOSING]]"},
       .text = "random blinks (EVERY 4000 ms, CLOSING 100 ms)",
       .more = "Adds blinks: a seed for their random times, the mean interval (4000) and the time "
               "that the lids take to close (100), in ms.",
       .value = parsed(Kind::Word, read_blink, playback.blink)},
      {.option = {"idle", "SEED"},
       .text = "blinks, glances and breathing",
       .more = "Adds blinks (with this SEED, unless --blink is given), saccades and breathing.",
       .value = parsed(Kind::Number, read_idle, playback)},
  };
}

std::vector<OptionRow> picture_rows(OutputOptions& output) {
  return {
      {.option = {"size", "WxH"},
       .text = "size of pictures and videos in pixels (800x600)",
       .more = "Size of the pictures in pixels, each side up to 8192: 800x600 by default, 300x375 "
               "in a gallery.",
       .value = parsed(Kind::Word, read_size, output),
       .heading = "Pictures"},
      {.option = {"background", "RRGGBB"},
       .text = "colour behind the face, or none: transparent PNGs",
       .more = "A plain background of this colour behind the face. The word none in place of a "
               "colour makes PNGs transparent there.",
       .value = parsed(Kind::Word, read_background, output)},
      {.option = {"show", "LAYER[,...]"},
       .text = "what is drawn: layers, see below (textured)",
       .more = "Layers: polygons, textured (the default), transparent, wireframe, vertices, "
               "muscles, jaw-tags, eye-tags.",
       .value = parsed(Kind::Word, read_layers, output.layers)},
  };
}

std::vector<OptionRow> sound_rows(SoundOptions& sound) {
  return {
      {.option = {"volume", "N", "100"},
       .text = "0 to 100 percent (100)",
       .more = "How loud the sound is, 0 to 100 percent of how it comes.",
       .value = whole(sound.volume, 0, 100),
       .heading = "Sound"},
      {.option = {"mute"},
       .text = "play silence in place of the sound",
       .more = "Plays silence; nothing else changes.",
       .value = flag(sound.mute)},
      {.option = {"sound", "FILE.wav"},
       .text = "write the sound to a file",
       .more = "Writes the sound to a WAV file, which has the length of the stream, and does not "
               "wait for the clock.",
       .value = word(sound.file)},
      {.option = {"no-sound"},
       .text = "no sound at all; videos are silent",
       .more = "Plays no sound, and asks the server for none. Videos of --record are silent.",
       .value = flag(sound.none)},
      {.option = {"sound-device", "NAME"},
       .text = "device to play on",
       .more = "The device to play on, or default. For an unknown name the available devices are "
               "listed. With --headless, sound is played only if this is given.",
       .value = word(sound.device)},
  };
}

OptionRow fps_row(OutputOptions& output) {
  return {
      .option = {"fps", "N"},
      .text = "frame rate of --record and --frames",
      .more =
          "Pictures a second, 1 to 240. In the window: samples a second of GLB files; and the keys "
          ", and . step by 1/N s (without --fps by a picture of the recording, or 1/25 s).",
      .value = whole(output.fps, 1, view::kVideoFpsMax)};
}

std::vector<OptionRow> video_rows(PlayerOptions& options) {
  OutputOptions& output = options.output;
  return {
      {.option = {"frames", "DIR"},
       .text = "write PNGs: 50 per keyframe; with --fps N, N a second",
       .more = "Writes DIR/frame_000001.png and so on: 50 for each keyframe or, with --fps N, N a "
               "second.",
       .value = word(output.frames)},
      {.option = {"record", "FILE"},
       .text = "write a video: .mp4, .webm or .gif",
       .more = "Writes a video, .mp4, .webm or .gif: 30 pictures a second or, with --fps N, N. It "
               "has the sound, if there is any; a .gif has none.",
       .value = word(output.record)},
      {.option = {"sheet", "FILE.png"},
       .text = "write the keyframes to one page, at most 54",
       .more = "Writes the poses of the keyframes to one page; if there are more than 54, as many "
               "from beginning to end, or of a server's every second, fourth, ... Without --size "
               "each is 400x300.",
       .value = word(output.sheet)},
      fps_row(output),
      {.option = {"fast"},
       .text = "no window; as fast as the computer can",
       .more = "No window, and no waiting for the clock: plays as fast as the computer can. "
               "Implied by --frames, --record, --sheet and --sound.",
       .value = flag(output.fast)},
      {.option = {"stats", "FILE.json"},
       .text = "write statistics at exit; - for stdout",
       .more = "Writes statistics of buffers, delays and frames at exit, with - to stdout.",
       .value = parsed(Kind::Word, read_output_path, output.stats)},
      {.option = {"onsets", "FILE.csv"},
       .text = "write when the window showed each change",
       .more = "Writes a row for each picture in which the face had moved: when the picture was on "
               "the display (CLOCK_MONOTONIC, s), its keyframe and its AUs, for the clock of an "
               "experiment. The last column is called reached. In the first picture that shows a "
               "keyframe whole it has that keyframe's number ('3-5' if several have ended since "
               "the picture before); in the other pictures it is empty. Only with the window.",
       .value = word(output.onsets)},
      {.option = {"headless"},
       .text = "no window; ends with the stream",
       .value = flag(options.headless),
       .heading = "Program"},
      {.option = {"language", "CODE"},
       .text = "language of the window, such as fr",
       .more = "The language of the window: en, or one of data/languages, such as fr. Without this "
               "option: the one last chosen in the window, or that of the locale.",
       .value = word(options.display.language)},
      {.option = {"text-size", "N"},
       .text = "size of the window's texts, 75 to 200 percent (100)",
       .more = "The size of all that is written in the window, in percent: 75 to 200 (100).",
       .value = whole(options.display.text_percent, gui::kTextPercentMin, gui::kTextPercentMax)},
      {.option = {"exit-at-end"},
       .text = "close the window when the stream ends",
       .more = "Closes the window when the stream ends.",
       .value = flag(options.exit_at_end)},
      {.option = {"no-config"},
       .text = "ignore the window's saved settings",
       .more = "The window neither reads nor writes ~/.config/aucast/face-player.toml.",
       .value = flag(options.config, false)},
  };
}

std::vector<OptionRow> program_rows(PlayerOptions& options) {
  return {
      {.option = {"log-level", "LEVEL", "warning"},
       .text = "trace, debug, info, warning, error, off (warning)",
       .value = log_level(options.log_level)},
      {.option = {"verbose"},
       .text = "the same as --log-level info; -vv: debug",
       .more = "The same as --log-level info; twice, as --log-level debug.",
       .value = flag(),
       .letter = 'v'},
      {.option = {"quiet"},
       .text = "errors only, no progress line",
       .more = "The same as --log-level error, and no progress line.",
       .value = flag(options.quiet),
       .letter = 'q'},
  };
}

OptionRow viewpoint_row(PoseOptions& pose) {
  std::vector<std::pair<std::string_view, view::ViewpointPreset>> names;
  for (const auto preset : {view::ViewpointPreset::Front, view::ViewpointPreset::ThreeQuarter,
                            view::ViewpointPreset::Profile}) {
    names.emplace_back(name(preset), preset);
  }
  return {.option = {"camera", "VIEW", "front"},
          .text = "front, three-quarter or profile (front)",
          .value = one_of(pose.viewpoint, std::move(names))};
}

OptionRow aus_row(PoseOptions& pose) {
  return {.option = {"aus", "AUS"},
          .text = "such as 1,6,12 or 12:80,R14:50 or 4C+9D",
          .more =
              "A set of AUs as in a packet, such as 1,6,12 or 12:80,R14:50, in FACS notation, such "
              "as 4C+9D, or by FACS names: 'Cheek Raiser:50'. L and R are the subject's own sides.",
          .value = word(pose.aus),
          .where = Where::Positional};
}

std::vector<OptionRow> pose_rows(PoseOptions& pose) {
  return {
      aus_row(pose),
      {.option = {"expression", "NAME"},
       .text = "a named expression, such as happiness",
       .more = "A named expression instead of AUS, such as happiness, thesis-anger or waters-fear; "
               "--list names them all.",
       .value = word(pose.expression)},
      {.option = {"muscle", "NAME=VALUE"},
       .text = "set a muscle or another channel; may be repeated",
       .more = "Sets a muscle or another channel after the mixer. May be repeated.",
       .value = parsed(Kind::Words, read_muscle, pose.muscles)},
      {.option = {"list"}, .text = "list channels, AUs and expressions", .value = flag(pose.list)},
      {.option = {"png", "FILE"}, .text = "write the picture", .value = word(pose.png)},
      {.option = {"obj", "FILE"},
       .text = "write the skin's mesh, not smoothed as for pictures",
       .more = "Writes the deformed skin as Wavefront OBJ, with the vertices in the order of the "
               "face's mesh. Pictures round off this mesh for a smooth outline, with a further "
               "vertex at each edge that bends.",
       .value = word(pose.obj)},
      viewpoint_row(pose),
  };
}

std::vector<OptionRow> gallery_rows(PlayerOptions& options) {
  GalleryOptions& gallery = options.gallery;
  return {
      {.option = {"dir", "DIR"},
       .text = "folder to write to; other files in it are kept",
       .value = word(gallery.folder),
       .where = Where::Positional},
      {.option = {"only", "SECTION[,...]"},
       .text = "only these sections, and what --sweep asks for",
       .more = "Only these sections: aus, prototypes, combinations, appendix-a, appendix-b, "
               "sweeps, coverage. May be repeated.",
       .value = parsed(Kind::Words, read_sections, gallery.only)},
      {.option = {"sweep", "AUS|NAME|all"},
       .text = "frames and a video, from neutral to full and back",
       .more =
           "From neutral to the apex and back, as frames, and as a video if ffmpeg is installed: "
           "of a set of AUs, of an expression, or of all AUs and all expressions. May be repeated.",
       .value = words(gallery.sweeps)},
      viewpoint_row(options.pose),
  };
}

std::vector<OptionRow> export_rows(PlayerOptions& options) {
  OptionRow fps = fps_row(options.output);
  fps.option.fallback = "30";
  fps.text = "animation samples a second, 1 to 240 (30)";
  fps.more = "Animation samples a second, 1 to 240.";
  std::vector<OptionRow> rows{
      {.option = {"files", "[STREAM] FILE.glb"},
       .more = "FILE.glb is the file to write. STREAM, a stream file or the table of a recogniser, "
               "becomes its animation; without STREAM the face has no animation.",
       .value = words(options.exported.files),
       .where = Where::Positional},
      {.option = {"basis", "BASIS", "muscles"},
       .text = "morph targets: muscles or aus (muscles)",
       .more = "muscles has a morph target for each muscle and lid, and is true to the face; aus "
               "has one for each Action Unit and side, to be driven by hand.",
       .value = one_of<glb::Basis>(options.exported.basis,
                                   {{"muscles", glb::Basis::Muscles}, {"aus", glb::Basis::Aus}}),
       .heading = "File"},
      std::move(fps)};
  return rows;
}

std::vector<OptionRow> security_rows(net::SecurityOptions& security) {
  return {
      {.option = {"tls"},
       .text = "use TLS",
       .more = "Encrypt the connection and verify the server's certificate.",
       .value = flag(security.tls),
       .heading = "TLS and tokens"},
      {.option = {"tls-ca", "FILE"},
       .text = "CAs to trust",
       .more = "Trust the authorities in FILE (PEM) and not the system's. If FILE has revocation "
               "lists, they are heeded; each authority that signs for servers then needs one that "
               "is up to date.",
       .value = word(security.files.authorities)},
      {.option = {"tls-cert", "FILE"},
       .text = "certificate to show, if the server wants one",
       .more = "The certificate to present if the server requires one (PEM).",
       .value = word(security.files.certificate)},
      {.option = {"tls-key", "FILE"},
       .text = "the private key of --tls-cert",
       .value = word(security.files.key)},
      {.option = {"token-file", "FILE"},
       .text = "token to show to the server",
       .more = "The file with the token that the server requires. The token is sent only over TLS "
               "or to this computer, unless --insecure-token is given.",
       .value = word(security.token)},
      {.option = {"insecure-token"},
       .text = "send the token even without TLS",
       .more = "Send the token without TLS to other computers too: anyone on the path can read it.",
       .value = flag(security.insecure_token)},
  };
}

}  // namespace

std::vector<OptionRow> table_rows(gui::TableSettings& table) {
  return {
      {.option = {"table-fps", "N"},
       .text = "pictures per second in a table without times",
       .more = "How many pictures a second a recogniser's table was made from, 1 to 1000. Without "
               "this option the table's own times count.",
       .value = whole(table.fps, 1, gui::kTableFpsMax),
       .heading = "Tables of recognisers"},
      {.option = {"table-gain", "PERCENT"},
       .text = "gain for all AUs of a table",
       .more = "Multiplies the intensities of all AUs of a table, 1 to 1000 percent.",
       .value = whole(table.gain_percent, 1, gui::kTableGainPercentMax)},
      {.option = {"table-neutral", "S"},
       .text = "the first S seconds show a neutral face: subtract it",
       .more = "The first S seconds of a table, 1 to 60, show a neutral face, which is subtracted "
               "from the whole table.",
       .value = whole(table.neutral_s, 1, gui::kTableNeutralMax)},
  };
}

std::vector<OptionRow> receiving_rows(PlaybackOptions& playback) {
  playback::BufferOptions& buffers = playback.buffers;
  std::vector<OptionRow> rows{
      {.option = {"buffer", "SIZE", "100"},
       .text = "Receiver buffer: sets (100), 300ms or auto",
       .more = "Capacity of the Receiver buffer, 1 to 10000 sets. With auto the buffer is counted "
               "in time instead, as much as the link needs; with a time such as 300ms, up to "
               "60000ms, it holds that much.",
       .value = parsed(Kind::Word, read_buffer, buffers),
       .heading = "Receiving"},
      {.option = {"playout", "N", "30"},
       .text = "sets about to be played: Playout buffer (30)",
       .more = "Capacity of the Playout buffer, in sets; no larger than --buffer.",
       .value = whole(buffers.playout_capacity, 1, playback::BufferOptions::kSetsMax)},
      {.option = {"threshold", "PERCENT", "40"},
       .text = "start when the Receiver buffer is this full (40)",
       .more = "How full the Receiver buffer must be before playback starts, 1 to 100 percent.",
       .value = whole(buffers.threshold_percent, 1, 100)},
      {.option = {"live"},
       .text = "lowest delay for live streams; may stall",
       .more = "The lowest delay of a live stream that the link allows, at the risk of stalls.",
       .value = flag(buffers.low_delay)},
      {.option = {"live-delay", "MS"},
       .text = "fixed delay for live streams (adapts to the link)",
       .more = "A fixed delay for live streams, up to 60000 ms. Without it the delay adapts to the "
               "link.",
       .value = parsed(Kind::Number, read_live_delay, buffers)},
      {.option = {"hold", "S", "5"},
       .text = "return to neutral after a stall of S seconds (5)",
       .value =
           seconds(playback.hold, 0, kSecondsMax, "is not a number of seconds from 0 to 86400")},
      {.option = {"stream", "NAME"},
       .text = "which of the server's streams (its first)",
       .more = "Which of the server's streams; its first one by default.",
       .value = word(playback.stream)},
      {.option = {"protocol", "LEVEL", "auto"},
       .text = "auto or classic (auto)",
       .more = "classic never sends a hello: for servers that know only level 1.",
       .value = one_of(playback.classic, {{"auto", false}, {"classic", true}})},
      {.option = {"connect-timeout", "S", "10"},
       .text = "longest wait to connect and for the first packet (10)",
       .more = "The longest wait for a connection and for its first packet, 0.01 to 86400 seconds.",
       .value = seconds(playback.connect_timeout, 0.01, kSecondsMax,
                        "is not a number of seconds from 0.01 to 86400")},
      {.option = {"reconnect"},
       .text = "when the connection is lost, hold the face and retry",
       .more = "When the connection is lost, hold the face and retry after 1, 2, 4, 8, 16, 30, 30 "
               "... seconds.",
       .value = flag(playback.reconnect)}};
  append(rows, security_rows(playback.security));
  return rows;
}

std::vector<OptionRow> option_rows(Command command, PlayerOptions& options) {
  std::vector<OptionRow> rows;
  if (command == Command::Watch) {
    rows = {
        {.option = {"host", "HOST"},
         .more = "The server: HOST or HOST:PORT; the port is 4650 by default. Or a stream's "
                 "address: aucast://HOST[:PORT][,HOST...][/STREAM], aucasts:// over TLS. Of "
                 "several hosts, the next one is tried when one is lost (as with --reconnect), is "
                 "full or does not have the stream yet. face-player gives up when all hosts have "
                 "refused it. Without a window it also gives up when no host could be reached at "
                 "first, unless --reconnect is given.",
         .value = word(options.playback.endpoint),
         .where = Where::Positional},
        {.option = {"list"},
         .more = "Prints the server's streams, one a line. On a terminal each has \"live\" or its "
                 "length, and its title, as far as the server tells them; a pipe or a file gets "
                 "the names alone.",
         .value = flag(options.list)},
        {.option = {"mirror"},
         .more = "Opens the window at its Camera tab: your own face as others will see it, beside "
                 "what the camera sees, and the button \"Go live\". HOST is a camera then: camera "
                 "(the default), camera:DEVICE, or a film to try it with. face-player starts "
                 "au-transmitter for this; scripts/install_models.sh must have fetched the models "
                 "that read faces. While you are live, guests can watch. With --token-file they "
                 "must show its token, and with --tls-cert and --tls-key they must come over TLS.",
         .value = flag(options.shows_mirror)}};
  } else if (command == Command::Play) {
    rows = {{.option = {"file", "FILE"},
             .text = "a stream file or a recogniser's table",
             .value = word(options.playback.file),
             .where = Where::Positional}};
  } else if (command == Command::Pose) {
    rows = pose_rows(options.pose);
  } else if (command == Command::Gallery) {
    rows = gallery_rows(options);
  } else if (command == Command::Export) {
    rows = export_rows(options);
  } else {
    rows = {aus_row(options.pose),
            {.option = {"explain"},
             .text = "a line for each rule that applied, and its reference",
             .value = flag(options.pose.explain)}};
  }
  const bool plays = command == Command::Watch || command == Command::Play;
  const bool draws = plays || command == Command::Pose || command == Command::Gallery;
  const bool moves = plays || command == Command::Export;
  if (command == Command::Play || command == Command::Export) {
    append(rows, table_rows(options.table));
  }
  if (plays) append(rows, receiving_rows(options.playback));
  if (moves) append(rows, animation_rows(options.playback));
  if (plays) append(rows, sound_rows(options.sound));
  if (command != Command::Rules) append(rows, face_rows(options.face));
  append(rows, rules_rows(options.face));
  if (draws) append(rows, picture_rows(options.output));
  if (plays) append(rows, video_rows(options));
  append(rows, program_rows(options));
  append(rows, help_rows());
  return rows;
}

}  // namespace aucast::app
