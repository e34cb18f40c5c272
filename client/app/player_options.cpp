#include "client/app/player_options.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "client/app/command_pages.h"
#include "client/app/option_rows.h"
#include "client/view/video_encoder.h"
#include "common/link/host.h"
#include "common/text.h"
#include "protocol/endpoint.h"
#include "protocol/limits.h"

namespace aucast::app {
namespace {

Result<void> settle_buffers(const TypedWords& typed, playback::BufferOptions& buffers) {
  const bool delay_typed = typed.contains("live-delay");
  const bool buffer_typed = buffers.by_time && typed.at("buffer").front() != "auto";
  if (buffers.low_delay && delay_typed) {
    return usage_error("--live takes the lowest delay and --live-delay another: give one of them");
  }
  if (buffers.low_delay && buffer_typed) {
    return usage_error("--live takes the lowest delay and --buffer another: give one of them");
  }
  if (delay_typed && buffer_typed) {
    return usage_error("--live-delay and --buffer both set the delay: give one of them");
  }
  if (buffers.playout_capacity > buffers.receiver_capacity && typed.contains("playout")) {
    return usage_error("--playout " + std::to_string(buffers.playout_capacity) +
                       " is larger than --buffer " + std::to_string(buffers.receiver_capacity));
  }
  buffers.playout_capacity = std::min(buffers.playout_capacity, buffers.receiver_capacity);
  return {};
}

/// No server is named like a stream file that is there.
Result<void> check_server_name(const std::string& name) {
  const std::string ending = file_ending(name);
  std::error_code ignored;
  const bool is_file =
      (ending == ".txt" || ending == ".csv") && std::filesystem::is_regular_file(name, ignored);
  if (!is_file) return {};
  return usage_error("'" + name + "' is a file, not a server: play it with face-player play " +
                     name);
}

/// Reads aucast://HOST/STREAM, which includes what other options say.
Result<void> settle_address(const TypedWords& typed, PlaybackOptions& playback) {
  if (!protocol::is_stream_address(playback.endpoint)) return check_server_name(playback.endpoint);
  auto address = protocol::parse_stream_address(playback.endpoint);
  if (!address) return address.error();
  if (!address->stream.empty()) {
    if (typed.contains("stream")) return usage_error("--stream and the address both name a stream");
    playback.stream = address->stream;
  }
  const protocol::Endpoint& first = address->hosts.front();
  playback.endpoint = link::host_and_port(first.host, first.port);
  playback.others.assign(address->hosts.begin() + 1, address->hosts.end());
  playback.reconnect = playback.reconnect || !playback.others.empty();
  playback.security.tls = playback.security.tls || address->tls;
  return {};
}

/// --mirror [SOURCE]: the word that names a server in other runs names a camera.
Result<void> settle_mirror(const TypedWords& typed, PlayerOptions& options) {
  if (!options.shows_mirror) return {};
  for (const char* name : {"stream", "tls", "tls-ca", "insecure-token", "reconnect", "protocol",
                           "live", "live-delay"}) {
    if (typed.contains(name)) {
      return usage_error(
          "--mirror shows your own camera, for which nothing is asked of a server: leave out --" +
          std::string(name));
    }
  }
  if (options.list || options.headless || options.output.fast || options.output.pictures()) {
    return usage_error(
        "--mirror shows your own camera in the window: leave out what does without one");
  }
  // The token and certificate files are what guests are asked for, not what is shown to a server.
  net::SecurityOptions& security = options.playback.security;
  options.mirror.token = std::exchange(security.token, {});
  options.mirror.certificate = std::exchange(security.files.certificate, {});
  options.mirror.key = std::exchange(security.files.key, {});
  std::string& source = options.playback.endpoint;
  if (!source.empty()) options.mirror.source = std::exchange(source, {});
  return {};
}

Result<void> check_background(const OutputOptions& output) {
  if (!output.transparent) return {};
  if (!output.record.empty())
    return usage_error("--record makes a video, which has no --background none");
  if (!output.sheet.empty())
    return usage_error("--sheet makes a page, which has no --background none");
  return {};
}

/// Where only the sheet is drawn, its pictures are half as wide and high as others: a page of them
/// is 3,750 pixels wide at most.
void settle_sheet(OutputOptions& output) {
  if (output.sheet.empty() || output.film() || output.size_given) return;
  output.width /= 2;
  output.height /= 2;
}

/// A name that tells of something else, such as face.jpg, is a mistake; none, or a device, is not.
Result<void> check_png(const char* option, const std::filesystem::path& file) {
  const std::string ending = file_ending(file);
  if (ending.empty() || ending == ".png") return {};
  return usage_error(std::string(option) + " writes a PNG: let its name end in .png");
}

Result<void> settle_sound(const PlayerOptions& options) {
  const SoundOptions& sound = options.sound;
  if (sound.none && !sound.file.empty()) {
    return usage_error("--no-sound leaves nothing for --sound to write: give one of them");
  }
  if (sound.none && sound.device) {
    return usage_error("--no-sound leaves nothing for --sound-device to play: give one of them");
  }
  if (!sound.file.empty() && file_ending(sound.file) != ".wav") {
    return usage_error("--sound writes a WAV file: let its name end in .wav");
  }
  return {};
}

/// Checks and completes what depends on more than one option.
Result<void> settle(const TypedWords& typed, PlayerOptions& options) {
  if (auto settled = settle_mirror(typed, options); !settled) return settled;
  if (auto settled = settle_address(typed, options.playback); !settled) return settled;
  if (auto png = check_png("--png", options.pose.png); !png) return png;
  if (auto png = check_png("--sheet", options.output.sheet); !png) return png;
  if (options.command == Command::Gallery && !options.output.size_given) {
    options.output.width = 300;
    options.output.height = 375;
  }
  if (options.command == Command::Watch || options.command == Command::Play) {
    auto& buffers = options.playback.buffers;
    if (auto settled = settle_buffers(typed, buffers); !settled) return settled;
    if (auto settled = settle_sound(options); !settled) return settled;
    if (auto checked = check_background(options.output); !checked) return checked;
    settle_sheet(options.output);
    if (options.output.pictures() || !options.sound.file.empty()) options.output.fast = true;
    if (options.output.fast) options.headless = true;
    // A window shows what is tried, and has a button to end it.
    options.playback.one_round =
        options.headless && !options.playback.others.empty() && !typed.contains("reconnect");
    if (options.headless && !options.output.onsets.empty()) {
      return usage_error("--onsets tells when the window showed a face: there is none");
    }
    if (options.output.fast && buffers.low_delay) {
      return usage_error("--live is for watching; --fast and pictures run on the video clock");
    }
  }
  return {};
}

Result<void> check_security(const PlaybackOptions& options) {
  const net::SecurityOptions& security = options.security;
  if (security.files.certificate.empty() != security.files.key.empty()) {
    return usage_error("--tls-cert and --tls-key go together");
  }
  if (options.classic && !security.token.empty()) {
    return usage_error("--token-file needs a hello, which --protocol classic never sends");
  }
  if (options.classic && !options.stream.empty()) {
    return usage_error("a stream's name needs a hello, which --protocol classic never sends");
  }
  return {};
}

Result<void> check_export(const ExportOptions& exported) {
  if (exported.files.empty() || exported.files.size() > 2) {
    return usage_error("export needs FILE.glb, or a stream file and FILE.glb");
  }
  if (file_ending(exported.glb()) != ".glb") {
    return usage_error("export writes a GLB file: let the name of '" +
                       escaped(exported.glb().string()) + "' end in .glb");
  }
  return {};
}

Result<void> check_required(const PlayerOptions& options) {
  if (auto secure = check_security(options.playback); !secure) return secure;
  switch (options.command) {
    case Command::Watch:
      if (options.headless && options.playback.endpoint.empty()) {
        return usage_error("--headless needs HOST[:PORT], or play FILE");
      }
      if (options.list && options.playback.endpoint.empty()) {
        return usage_error("--list needs HOST[:PORT]");
      }
      if (options.list && options.playback.classic) {
        return usage_error("--list asks what --protocol classic cannot");
      }
      break;
    case Command::Play:
      if (options.playback.file.empty()) return usage_error("play needs a stream FILE");
      break;
    case Command::Rules:
      if (options.pose.aus.empty()) return usage_error("rules needs a set of AUs, such as 1,6,12");
      break;
    case Command::Gallery:
      if (options.gallery.folder.empty())
        return usage_error("gallery needs a folder DIR to write to");
      break;
    case Command::Export:
      return check_export(options.exported);
    case Command::Pose:
    case Command::Help:
      break;
  }
  return {};
}

/// Whether an option takes the word after it, according to the first command that has the option.
bool takes_a_word(const std::string& option) {
  for (const CommandPage& page : command_pages()) {
    for (const OptionRow& row : page.rows) {
      if (typed_name(row) == option) return row.value.kind != OptionValue::Kind::Flag;
    }
  }
  return false;
}

/// Takes the word that names a command out of the arguments: the first that is neither an option
/// nor the word of one.
Command take_command(std::vector<std::string>& arguments) {
  static const std::map<std::string, Command> kCommands{{"play", Command::Play},
                                                        {"pose", Command::Pose},
                                                        {"rules", Command::Rules},
                                                        {"gallery", Command::Gallery},
                                                        {"export", Command::Export}};
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word.starts_with("-")) {
      if (takes_a_word(word)) ++i;
      continue;
    }
    const auto command = kCommands.find(word);
    if (command == kCommands.end()) break;
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    return command->second;
  }
  return Command::Watch;
}

}  // namespace

bool wants_video_sound(const SoundOptions& sound, const OutputOptions& output) {
  return !sound.none && (!sound.file.empty() || view::VideoEncoder::takes_sound(output.record));
}

bool PlayerOptions::wants_voice() const {
  if (sound.none) return false;
  if (output.fast) return wants_video_sound(sound, output);
  return !headless || sound.device.has_value();
}

Result<PlayerOptions> parse_player_options(std::vector<std::string> arguments) {
  PlayerOptions options;
  options.playback.buffers.adapt = true;  // unless a delay is given
  options.command = take_command(arguments);
  const std::vector<OptionRow> rows = option_rows(options.command, options);
  auto typed = sort_arguments(rows, std::move(arguments));
  if (!typed) return typed.error();
  if (typed->contains("help") || typed->contains("version")) {
    options.text =
        typed->contains("help") ? help_text(command_page(options.command)) : version_text();
    options.command = Command::Help;
    return options;
  }
  for (const auto& [name, words] : *typed) options.given.insert(typed_name(*find_row(rows, name)));
  if (auto level = apply_verbosity(*typed, {"info", "debug"}); !level) return level.error();
  if (auto read = read_words(rows, *typed); !read) return read.error();
  if (auto settled = settle(*typed, options); !settled) return settled.error();
  options.playback.voice = options.wants_voice();
  if (auto complete = check_required(options); !complete) return complete.error();
  return options;
}

std::string version_text() {
  return "face-player " AUCAST_VERSION " (protocol " + std::to_string(protocol::kProtocolVersion) +
         "), MIT licence\n";
}

std::string manual_page() {
  ManualPage page("face-player", AUCAST_VERSION, "draws a face that comes as FACS Action Units");
  for (const CommandPage& command : command_pages()) {
    page.section(command.command.empty() ? "DESCRIPTION" : command.command);
    page.command(command);
  }
  page.section("SEE ALSO");
  page.paragraph("au-transmitter(1)");
  return page.text();
}

std::optional<std::string> completion(const std::vector<std::string>& arguments) {
  return asked_completion(arguments, command_pages());
}

}  // namespace aucast::app
