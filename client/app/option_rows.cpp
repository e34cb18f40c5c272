#include "client/app/option_rows.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "client/gallery/section_names.h"
#include "client/playback/playback_controller.h"
#include "client/view/video_encoder.h"
#include "common/number_of.h"
#include "common/text.h"

namespace aucast::app {
namespace {

using Kind = OptionValue::Kind;
using Where = OptionRow::Where;

constexpr int kSizeMax = view::kVideoSideMax;
constexpr double kSecondsMax = 86'400;
constexpr int kDelayMaxMs = playback::BufferOptions::kDelayMax.count();
constexpr int kSpeedMaxMs = playback::PlaybackController::kSpeedMax.count();

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
      {"face", "NAME", "default", "name of a face, or its folder (default)",
       "The name of a face in data/faces, or its folder.", word(face.face), "Face"},
      {"mixer", "MIXER", "maximum", "for AUs sharing a muscle: maximum, average (maximum)",
       "How contractions of one muscle by several AUs are combined: maximum or average.",
       one_of<face::Mixer>(face.mixer,
                           {{"maximum", face::Mixer::Maximum}, {"average", face::Mixer::Average}})},
  };
}

std::vector<OptionRow> rules_rows(FaceOptions& face) {
  return {
      {"rules", "RULES", "facs", "facs, kumar2010, none or FILE (facs)",
       "The co-occurrence rules: facs, kumar2010 (as published), none, or a file.",
       word(face.rules)},
      {"data", "DIR", "", "folder with faces, rules and streams",
       "The folder with faces, rules and streams, if not the installed one.", word(face.data)},
  };
}

std::vector<OptionRow> animation_rows(PlaybackOptions& playback) {
  using playback::Interpolation;
  return {
      {"speed", "MS", "", "time of keyframes without one (250)",
       "Duration of keyframes without a time of their own, 1 to 1000 ms. Without it: 250 ms, "
       "or what a server says.",
       whole(playback.speed, 1, kSpeedMaxMs), "Animation"},
      {"interpolation", "KIND", "linear", "linear or cosine (linear)",
       "Between keyframes: linear or cosine.",
       one_of<Interpolation>(playback.interpolation, {{"linear", Interpolation::Linear},
                                                      {"cosine", Interpolation::Cosine}})},
      {"blink", "SEED[:EVERY[:CLOSING]]", "", "random blinks; times in ms (4000:100)",
       "Adds blinks: a seed for their random times, the mean interval (4000) and the time "
       "that the lids take to close (100), in ms.",
       parsed(Kind::Word, read_blink, playback.blink)},
      {"idle", "SEED", "", "blinks, glances and breathing",
       "Adds blinks (--blink SEED unless given), saccades and breathing.",
       parsed(Kind::Number, read_idle, playback)},
  };
}

std::vector<OptionRow> picture_rows(OutputOptions& output) {
  return {
      {"size", "WxH", "", "size of the pictures in pixels",
       "Size of the pictures in pixels, each side up to 8192: 800x600 by default, 300x375 in "
       "a gallery.",
       parsed(Kind::Word, read_size, output), "Pictures"},
      {"background", "RRGGBB", "", "a plain colour behind the face, or none",
       "A plain background of this colour behind the face; with none, PNGs are transparent there.",
       parsed(Kind::Word, read_background, output)},
      {"show", "LAYER[,...]", "", "what is drawn: layers, see below (textured)",
       "Layers: polygons, textured (the default), transparent, wireframe, vertices, muscles, "
       "jaw-tags, eye-tags.",
       parsed(Kind::Word, read_layers, output.layers)},
  };
}

std::vector<OptionRow> sound_rows(SoundOptions& sound) {
  return {
      {"volume", "N", "100", "0 to 100 percent (100)",
       "How loud the sound is, 0 to 100 percent of how it comes.", whole(sound.volume, 0, 100),
       "Sound"},
      {"mute", "", "", "play silence in place of the sound", "Plays silence; nothing else changes.",
       flag(sound.mute)},
      {"sound", "FILE.wav", "", "write the sound to a file",
       "Writes the sound to a WAV file, as long as the stream, and does not wait for the clock.",
       word(sound.file)},
      {"no-sound", "", "", "no sound at all; videos are silent",
       "Plays no sound, and asks the server for none. Videos of --record are silent.",
       flag(sound.none)},
      {"sound-device", "NAME", "", "device to play on",
       "The device to play on, or default. For an unknown name the available devices are "
       "listed. With --headless, sound is played only if this is given.",
       word(sound.device)},
  };
}

OptionRow fps_row(OutputOptions& output) {
  return {
      "fps",
      "N",
      "",
      "frame rate of --record and --frames",
      "Pictures a second, 1 to 240. In the window: of GLB files, and what , and . step by (25).",
      whole(output.fps, 1, view::kVideoFpsMax)};
}

std::vector<OptionRow> film_rows(PlayerOptions& options) {
  OutputOptions& output = options.output;
  return {
      {"frames", "DIR", "", "write PNGs: 50 per keyframe; with --fps N, N a second",
       "Writes DIR/frame_000001.png and so on: 50 a keyframe, or --fps N a second.",
       word(output.frames)},
      {"record", "FILE", "", "write a video: .mp4, .webm or .gif",
       "Writes a video, .mp4, .webm or .gif: 30 pictures a second, or --fps N. It has the sound, "
       "if there is any; a .gif has none.",
       word(output.record)},
      {"sheet", "FILE.png", "", "write the keyframes to one page, at most 60",
       "Writes the poses of the keyframes to one page; if there are more than 60, only every "
       "second, fourth, ...",
       word(output.sheet)},
      fps_row(output),
      {"fast", "", "", "do not wait for the clock",
       "Does not wait for the clock: plays as fast as the computer can. Implied by --frames, "
       "--record, --sheet and --sound.",
       flag(output.fast)},
      {"stats", "FILE.json", "", "write statistics at exit",
       "Writes statistics of buffers, delays and frames at exit.", word(output.stats)},
      {"onsets", "FILE.csv", "", "write the time at which each face was shown",
       "Writes when each face was on the display (CLOCK_MONOTONIC, s), its keyframe and its AUs: "
       "for the clock of an experiment. The last column, reached, has the number of a keyframe "
       "in the first picture that shows all of it ('3-5' where several have ended since the "
       "picture before), and is empty in the others. Only with the window.",
       word(output.onsets)},
      {"headless", "", "", "no window; ends with the stream", "", flag(options.headless),
       "Program"},
      {"language", "CODE", "", "language of the window, such as fr",
       "The language of the window: en, or one of data/languages, such as fr. Otherwise the one "
       "chosen there last, or that of the locale.",
       word(options.display.language)},
      {"text-size", "N", "", "size of its texts in percent, 75 to 200 (100)",
       "The size of all that is written in the window, in percent: 75 to 200 (100).",
       whole(options.display.text_percent, gui::kTextPercentMin, gui::kTextPercentMax)},
      {"exit-at-end", "", "", "close the window when the stream ends",
       "Closes the window when the stream ends.", flag(options.exit_at_end)},
      {"no-config", "", "", "ignore the window's saved settings",
       "The window neither reads nor writes ~/.config/aucast/face-player.toml.",
       flag(options.config, false)},
  };
}

std::vector<OptionRow> program_rows(PlayerOptions& options) {
  return {
      {"log-level", "LEVEL", "warning", "trace, debug, info, warning, error, off (warning)", "",
       log_level(options.log_level)},
      {"verbose", "", "", "the same as --log-level info; -vv: debug",
       "The same as --log-level info; twice, as --log-level debug.", flag(), "", Where::Anywhere,
       'v'},
      {"quiet", "", "", "errors only, no progress line",
       "The same as --log-level error, and no progress line.", flag(options.quiet), "",
       Where::Anywhere, 'q'},
  };
}

OptionRow viewpoint_row(PoseOptions& pose) {
  return {"camera", "VIEW",
          "front",  "front, three-quarter or profile (front)",
          "",       one_of(pose.viewpoint, {"front", "three-quarter", "profile"})};
}

OptionRow aus_row(PoseOptions& pose) {
  return {"aus",
          "AUS",
          "",
          "such as 1,6,12 or 12:80,R14:50 or 4C+9D",
          "A set of AUs as in a packet, such as 1,6,12 or 12:80,R14:50, in FACS notation, such as "
          "4C+9D, or by FACS names: 'Cheek Raiser:50'. L and R are the subject's own sides.",
          word(pose.aus),
          "",
          Where::Positional};
}

std::vector<OptionRow> pose_rows(PoseOptions& pose) {
  return {
      aus_row(pose),
      {"expression", "NAME", "", "a prototype in place of AUS, such as happiness",
       "A prototype instead of AUS, such as happiness, thesis-anger or waters-fear; --list "
       "names them all.",
       word(pose.expression)},
      {"muscle", "NAME=VALUE", "", "set a muscle or another channel; may be repeated",
       "Sets a muscle or another channel after the mixer. May be repeated.",
       parsed(Kind::Words, read_muscle, pose.muscles)},
      {"list", "", "", "list channels, AUs and expressions", "", flag(pose.list)},
      {"png", "FILE", "", "write the picture", "", word(pose.png)},
      {"obj", "FILE", "", "write the skin",
       "Writes the deformed skin as Wavefront OBJ, vertices in the order of the face.",
       word(pose.obj)},
      viewpoint_row(pose),
  };
}

std::vector<OptionRow> gallery_rows(PlayerOptions& options) {
  GalleryOptions& gallery = options.gallery;
  return {
      {"dir", "DIR", "", "folder to write to; other files in it are kept", "", word(gallery.folder),
       "", Where::Positional},
      {"only", "SECTION[,...]", "", "only these sections, see below",
       "Only these sections: aus, prototypes, combinations, appendix-a, appendix-b, sweeps, "
       "coverage. May be repeated.",
       parsed(Kind::Words, read_sections, gallery.only)},
      {"sweep", "AUS|NAME|all", "", "frames and a video, from neutral to full and back",
       "From neutral to the apex and back, as frames, and as a video if ffmpeg is installed: "
       "a set of AUs, an expression, or all of both. May be repeated.",
       words(gallery.sweeps)},
      viewpoint_row(options.pose),
  };
}

std::vector<OptionRow> export_rows(PlayerOptions& options) {
  OptionRow fps = fps_row(options.output);
  fps.fallback = "30";
  fps.text = "animation samples a second, 1 to 240 (30)";
  fps.more = "Animation samples a second, 1 to 240.";
  std::vector<OptionRow> rows{
      {"files", "[STREAM] FILE.glb", "", "",
       "A stream file or the table of a recogniser, which becomes the animation, and the file to "
       "write; or the file alone, for the face without an animation.",
       words(options.exported.files), "", Where::Positional},
      {"basis", "BASIS", "muscles", "morph targets: muscles or aus (muscles)",
       "What there is a morph target for: muscles, one for each muscle and lid, true to the face; "
       "or aus, one for each Action Unit and side, to be driven by hand.",
       one_of<glb::Basis>(options.exported.basis,
                          {{"muscles", glb::Basis::Muscles}, {"aus", glb::Basis::Aus}}),
       "File"},
      std::move(fps)};
  return rows;
}

}  // namespace

std::vector<OptionRow> table_rows(gui::TableSettings& table) {
  return {
      {"table-fps", "N", "", "pictures a second of a table without times",
       "Pictures a second that a recogniser's table was made from, 1 to 1000. Without it: what its "
       "own times say.",
       whole(table.fps, 1, gui::kTableFpsMax), "Tables of recognisers"},
      {"table-gain", "PERCENT", "", "gain for all AUs of a table",
       "Multiplies the intensities of all AUs of a table, 1 to 1000 percent.",
       whole(table.gain_percent, 1, gui::kTableGainPercentMax)},
      {"table-neutral", "S", "", "subtract the face of the first S s, taken as neutral",
       "For how many seconds at first the face of a table is neutral, 1 to 60; the face that it "
       "shows there is subtracted.",
       whole(table.neutral_s, 1, gui::kTableNeutralMax)},
  };
}

std::vector<OptionRow> receiving_rows(PlaybackOptions& playback) {
  playback::BufferOptions& buffers = playback.buffers;
  net::SecurityOptions& security = playback.security;
  return {
      {"buffer", "N", "100", "Receiver buffer: N AU sets (100), a time or auto",
       "Capacity of the Receiver buffer, 1 to 10000 sets. auto buffers by time instead, as "
       "much as the link needs; a time such as 300ms, up to 60000ms, buffers that much.",
       parsed(Kind::Word, read_buffer, buffers), "Receiving"},
      {"playout", "N", "30", "Playout buffer, in sets (30)",
       "Capacity of the Playout buffer, in sets; no larger than --buffer.",
       whole(buffers.playout_capacity, 1, playback::BufferOptions::kSetsMax)},
      {"threshold", "PERCENT", "40", "start when the Receiver buffer is this full (40)",
       "How full the Receiver buffer must be before playback starts, 1 to 100 percent.",
       whole(buffers.threshold_percent, 1, 100)},
      {"live", "", "", "play a live stream with the lowest delay",
       "The lowest delay of a live stream that the link allows, at the risk of stalls.",
       flag(buffers.low_delay)},
      {"live-delay", "MS", "", "a fixed delay for live streams",
       "A fixed delay for live streams, up to 60000 ms. Without it the delay adapts to the "
       "link.",
       parsed(Kind::Number, read_live_delay, buffers)},
      {"hold", "S", "5", "return to neutral after a stall of S seconds (5)", "",
       seconds(playback.hold, 0, kSecondsMax, "is not a number of seconds from 0 to 86400")},
      {"stream", "NAME", "", "which of the server's streams (its first)",
       "Which of the server's streams; its first one by default.", word(playback.stream)},
      {"protocol", "LEVEL", "auto", "auto or classic (auto)",
       "classic never sends a hello: for servers that know only level 1.",
       one_of(playback.classic, {{"auto", false}, {"classic", true}})},
      {"connect-timeout", "S", "10", "give up connecting after S seconds (10)",
       "The longest wait for a connection and for its first packet, 0.01 to 86400 seconds.",
       seconds(playback.connect_timeout, 0.01, kSecondsMax,
               "is not a number of seconds from 0.01 to 86400")},
      {"reconnect", "", "", "when the connection is lost, hold the face and retry",
       "When the connection is lost, hold the face and retry after 1, 2, 4, 8, 16, 30, 30 "
       "... seconds.",
       flag(playback.reconnect)},
      {"tls", "", "", "use TLS", "Encrypt the connection and verify the server's certificate.",
       flag(security.tls), "TLS and tokens"},
      {"tls-ca", "FILE", "", "CAs to trust",
       "Trust the authorities in FILE (PEM) and not the system's. Revocation lists in FILE are "
       "heeded; each authority that signs for servers then needs one that is up to date.",
       word(security.files.authorities)},
      {"tls-cert", "FILE", "", "certificate to show, if the server wants one",
       "The certificate to present if the server requires one (PEM).",
       word(security.files.certificate)},
      {"tls-key", "FILE", "", "the private key of --tls-cert", "", word(security.files.key)},
      {"token-file", "FILE", "", "token to show to the server",
       "The file with the token that the server requires. It is sent over TLS, to this "
       "computer, or with --insecure-token.",
       word(security.token)},
      {"insecure-token", "", "", "send the token even without TLS",
       "Send the token without TLS to other computers too: anyone on the path can read it.",
       flag(security.insecure_token)},
  };
}

std::vector<OptionRow> option_rows(Command command, PlayerOptions& options) {
  std::vector<OptionRow> rows;
  if (command == Command::Watch) {
    rows = {
        {"host", "HOST", "", "",
         "The server: HOST or HOST:PORT; the port is 4650 by default. Or a stream's address: "
         "aucast://HOST[:PORT][,HOST...][/STREAM], aucasts:// over TLS. The next of several "
         "hosts is tried when one is lost (as with --reconnect), is full or does not have the "
         "stream yet; it gives up when all have refused, and without window and --reconnect also "
         "when none could be reached at first.",
         word(options.playback.endpoint), "", Where::Positional},
        {"list", "", "", "",
         "Prints the server's streams, one a line: on a terminal with \"live\" or their length, "
         "and their title, as far as the server tells; to a pipe or file the names alone.",
         flag(options.list)},
        {"mirror", "", "", "",
         "Begins with the window's Camera tab: your own face as others will see it, beside what "
         "the camera sees, with \"Go live\" there. In place of HOST stands the camera: camera "
         "(the default), camera:DEVICE, or a film to try it with. au-transmitter is started for "
         "it, and scripts/install_models.sh must have fetched the models that read faces. While it "
         "is live, guests must show the token of --token-file and come over TLS with --tls-cert "
         "and --tls-key.",
         flag(options.shows_mirror)}};
  } else if (command == Command::Play) {
    rows = {{"file", "FILE", "", "a stream file or a recogniser's table", "",
             word(options.playback.file), "", Where::Positional}};
  } else if (command == Command::Pose) {
    rows = pose_rows(options.pose);
  } else if (command == Command::Gallery) {
    rows = gallery_rows(options);
  } else if (command == Command::Export) {
    rows = export_rows(options);
    append(rows, table_rows(options.table));
    append(rows, animation_rows(options.playback));
    append(rows, face_rows(options.face));
    append(rows, rules_rows(options.face));
    append(rows, program_rows(options));
    append(rows, help_rows());
    return rows;
  } else {
    rows = {aus_row(options.pose),
            {"explain", "", "", "a line for each rule that applied, with its source", "",
             flag(options.pose.explain)}};
    append(rows, rules_rows(options.face));
    append(rows, program_rows(options));
    append(rows, help_rows());
    return rows;
  }
  const bool plays = command == Command::Watch || command == Command::Play;
  if (command == Command::Play) append(rows, table_rows(options.table));
  if (plays) append(rows, receiving_rows(options.playback));
  if (plays) append(rows, animation_rows(options.playback));
  if (plays) append(rows, sound_rows(options.sound));
  append(rows, face_rows(options.face));
  append(rows, rules_rows(options.face));
  append(rows, picture_rows(options.output));
  if (plays) append(rows, film_rows(options));
  append(rows, program_rows(options));
  append(rows, help_rows());
  return rows;
}

}  // namespace aucast::app
