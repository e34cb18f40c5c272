#include "client/player_app.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <memory>

#include "client/app/assets.h"
#include "client/app/commands/clocked_run.h"
#include "client/app/commands/export_command.h"
#include "client/app/commands/pose_command.h"
#include "client/app/files_read.h"
#include "client/app/gallery/gallery_command.h"
#include "client/app/player_options.h"
#include "client/app/player_stats.h"
#include "client/app/remote_options.h"
#include "client/app/sound_device.h"
#include "client/app/stream_files.h"
#include "client/app/stream_table.h"
#include "client/app/video/video_run.h"
#include "client/app/window/settings/window_settings.h"
#include "client/app/window/window_run.h"
#include "client/net/remote_source.h"
#include "client/net/security.h"
#include "client/net/stream_list.h"
#include "client/playback/file_source.h"
#include "client/playback/seekable_playback.h"
#include "client/playback/source_playback.h"
#include "client/sound/openal_out.h"
#include "common/files.h"
#include "common/log.h"
#include "common/standard_output.h"

namespace aucast::app {
namespace {

using playback::SourcePlayback;

volatile std::sig_atomic_t g_interrupted = 0;

void on_signal(int) {
  g_interrupted = 1;
}

bool stop_asked() {
  return g_interrupted != 0;
}

/// SIGINT, SIGTERM and SIGHUP (a terminal that is gone, unless nohup ignores it) end playing in
/// good order. A broken pipe is an error and does not end the program.
void set_up_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second one ends the program at once
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  struct sigaction before {};
  ::sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) ::sigaction(SIGHUP, &action, nullptr);
  action.sa_handler = SIG_IGN;
  action.sa_flags = 0;
  ::sigaction(SIGPIPE, &action, nullptr);
}

/// Opens a stream file. In a window it can be sought; without one it is played as if it came from a
/// server.
Result<std::unique_ptr<playback::Playback>> open_file(const PlayerOptions& options,
                                                      const SourcePlayback::Options& how) {
  auto keyframes = open_typed_stream(options.playback.file, options.table);
  if (!keyframes) return keyframes.error();
  if (!options.headless) {
    return std::unique_ptr<playback::Playback>(std::make_unique<playback::SeekablePlayback>(
        *std::move(keyframes), options.playback.speed.value_or(protocol::kDefaultKeyframeTime)));
  }
  auto source = std::make_unique<playback::FileSource>(
      *std::move(keyframes), options.playback.speed.value_or(protocol::kDefaultKeyframeTime));
  return std::unique_ptr<playback::Playback>(
      std::make_unique<SourcePlayback>(std::move(source), how));
}

/// The server of the command line, and how it is reached.
struct Server {
  net::Endpoint endpoint;  ///< without a host: none was named
  net::Security security;
};

std::unique_ptr<playback::Playback> open_remote(const PlaybackOptions& options,
                                                const Server& server,
                                                const SourcePlayback::Options& how) {
  return std::make_unique<SourcePlayback>(std::make_unique<net::RemoteSource>(remote_options(
                                              options, server.endpoint, server.security)),
                                          how);
}

/// The sound file beside the stream file that is played without a window; null: none.
Result<std::unique_ptr<sound::SoundTrack>> open_track(const PlayerOptions& options) {
  std::unique_ptr<sound::SoundTrack> none;
  if (options.command != Command::Play || !options.headless || !options.wants_voice()) return none;
  return open_sound_beside(options.playback.file, stop_asked);
}

Result<void> print_list(const PlaybackOptions& options, const Server& server) {
  const auto list = net::list_streams(remote_options(options, server.endpoint, server.security));
  if (!list) return list.error();
  // A program that reads the names gets nothing else.
  const bool for_people = ::isatty(STDOUT_FILENO) == 1;
  return print_now(for_people ? stream_table(*list) : stream_names(*list));
}

/// The error that the end of a source means for the exit code, if it is one.
Result<void> outcome(const playback::SourceStatus& status) {
  switch (status.end) {
    case playback::EndReason::NotEnded:
    case playback::EndReason::EndOfStream:
    case playback::EndReason::Stopped:
      return {};
    case playback::EndReason::ConnectionLost:
    case playback::EndReason::ProtocolError:
    case playback::EndReason::Unreachable:
    case playback::EndReason::Refused:
      break;
  }
  return Error{ErrorKind::Network, status.detail};
}

Result<void> play(const PlayerOptions& given, const Server& server, PlayerStats& stats) {
  WindowSettings settings = WindowSettings::load(given);
  PlayerOptions options = settings.applied(given);
  options.playback.captions = !options.headless;
  SourcePlayback::Options how{options.playback.speed, options.playback.hold, false};
  if (options.output.fast) how = {options.playback.speed, std::nullopt, true};
  std::unique_ptr<playback::Playback> playback;
  if (options.command == Command::Play) {
    auto opened = open_file(options, how);
    if (!opened) return opened.error();
    playback = std::move(*opened);
  }
  auto assets = load_assets(options.face);
  if (!assets && options.face.face != given.face.face) {
    spdlog::warn("{}; the window begins with the usual face", assets.error().message);
    FaceOptions usual = options.face;
    usual.face = given.face.face;
    assets = load_assets(usual);
  }
  if (!assets) return assets.error();
  if (!options.output.fast) {
    if (auto writable = check_last_outputs(options.output); !writable) return writable;
  }
  // Not before it is clear that something will be shown: a device is taken from who else wants it.
  auto sound_out = open_sound(options);
  auto track = open_track(options);
  if (!track) return track.error();
  if (!server.endpoint.host.empty()) {
    playback = open_remote(options.playback, server, how);
  }
  Result<void> done;
  if (!options.headless) {
    done =
        run_window(**assets, options, playback, std::move(sound_out), settings, stop_asked, stats);
  } else if (options.output.fast) {
    done = run_video(**assets, options, *playback, track->get(), stop_asked, stats);
  } else {
    run_clocked(**assets, options, *playback, std::move(sound_out), track->get(), stop_asked,
                stats);
  }
  if (playback == nullptr) {
    stats.end_reason = "stopped";
    return done;
  }
  const playback::SourceStatus status = playback->status();
  stats.take(status);
  if (!done) stats.end_reason = "failed";
  return done ? outcome(status) : done;
}

/// The server of the command line, with its certificates and token, read before anything is
/// connected or drawn.
Result<Server> load_server(const PlaybackOptions& options) {
  Server server;
  if (!options.endpoint.empty()) {
    auto endpoint = net::parse_endpoint(options.endpoint);
    if (!endpoint) return endpoint.error();
    server.endpoint = *std::move(endpoint);
  }
  auto security = net::load_security(options.security, server.endpoint.host);
  if (!security) return security.error();
  if (!security->warning.empty()) spdlog::warn("{}", security->warning);
  server.security = *std::move(security);
  return server;
}

/// Plays, and writes --stats whether or not that succeeded.
Result<void> play_and_count(const PlayerOptions& options, const Server& server) {
  PlayerStats stats;
  stats.local = options.command == Command::Play;
  Result<void> played = play(options, server, stats);
  if (!played && stats.detail.empty()) stats.detail = played.error().message;
  if (options.output.stats.empty()) return played;
  auto written = write_file_atomically(options.output.stats, to_json(stats));
  return played ? written : played;
}

Result<void> run(const PlayerOptions& options) {
  if (auto log = set_up_log("face-player", options.log_level); !log) return log;
  if (auto kept = check_outputs(options); !kept) return kept;
  switch (options.command) {
    case Command::Help:
      std::fputs(options.text.c_str(), stdout);
      return {};
    case Command::Pose:
      return run_pose(options);
    case Command::Rules:
      return run_rules(options);
    case Command::Export:
      return run_export(options);
    case Command::Gallery:
      set_up_signals();
      return run_gallery(options, stop_asked);
    case Command::Watch:
    case Command::Play:
      break;
  }
  // What is asked of a silent server is ended as the system ends programs.
  if (!options.list) set_up_signals();
  const auto server = load_server(options.playback);
  if (!server) return server.error();
  if (options.list) return print_list(options.playback, *server);
  return play_and_count(options, *server);
}

int report(const Error& error) {
  print_error("face-player: " + error.message);
  return exit_code(error);
}

}  // namespace

int run_player(std::vector<std::string> arguments) {
  ignore_file_size_signal();
  sound::quieten_openal();
  // For the build, which installs both.
  const bool page = arguments == std::vector<std::string>{"--help-man"};
  const std::optional<std::string> script = page ? manual_page() : completion(arguments);
  if (script) {
    if (const auto printed = print_now(*script); !printed) return report(printed.error());
    return 0;
  }
  const auto options = parse_player_options(std::move(arguments));
  Result<void> done = options ? run(*options) : Result<void>(options.error());
  if (done) done = print_now();
  return done ? 0 : report(done.error());
}

}  // namespace aucast::app
