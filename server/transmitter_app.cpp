#include "server/transmitter_app.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <utility>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>

#include "common/files.h"
#include "common/log.h"
#include "common/result.h"
#include "common/standard_output.h"
#include "common/text.h"
#include "server/manual_page.h"
#include "server/serve/push_checks.h"
#include "server/serve/transmitter.h"
#include "server/settings/transmitter_options.h"
#include "server/status/stats.h"
#include "server/streams/check_report.h"
#include "server/streams/convert_command.h"
#include "server/streams/estimate.h"
#include "server/streams/load_repertoire.h"
#include "server/streams/measured_profile.h"
#include "server/streams/repertoire.h"
#include "server/streams/source_checks.h"

namespace aucast::server {
namespace {

/// Writes the error to stderr and returns the exit code. Lines of bad data begin with
/// file:line:column, as editors and compilers have them.
int report(const Error& error) {
  const char* prefix = error.kind == ErrorKind::BadData ? "" : "au-transmitter: ";
  print_error(prefix + error.message);
  return exit_code(error);
}

int check(const TransmitterOptions& options) {
  const auto pushes = check_pushes(options);
  if (!pushes) return report(pushes.error());
  if (const auto printed = print_now(*pushes); !printed) return report(printed.error());
  const SignalOptions& signal = options.source.signal;
  const auto conditioning = conditioning_of(signal);
  if (!conditioning) return report(conditioning.error());
  const auto sources = load_asked(options, *conditioning);
  if (!sources) return report(sources.error());
  if (const auto saved = save_measured_profile(signal, *conditioning, *sources); !saved) {
    return report(saved.error());
  }
  for (const Source& source : *sources) {
    std::optional<VoiceSummary> voice;
    if (source.voice) {
      auto summary = summarise_voice(*source.voice, options.voice.encoder);
      if (!summary) return report(summary.error());
      voice = std::move(*summary);
    }
    const VoiceSummary* const spoken = voice ? &*voice : nullptr;
    const auto printed =
        print_now(options.estimate ? estimate_report(source, options.batch, spoken)
                                   : check_report(source, options.keyframe_ms, spoken));
    if (!printed) return report(printed.error());
  }
  return 0;
}

/// Keeps signals from ending the process before --stats is written: Asio restores a signal's
/// default action when the last set that has it is gone, so this set lives until the end.
void keep_signals() {
  struct Kept {
    asio::io_context io;
    asio::signal_set end{io, SIGINT, SIGTERM};
    asio::signal_set other{io, SIGHUP, SIGUSR1};
  };
  static const Kept* const kept = new Kept;
  static_cast<void>(kept);
}

int serve_until_signal(const TransmitterOptions& options, Repertoire repertoire) {
  keep_signals();
  Stats stats;
  const auto served = serve(
      options, std::move(repertoire), stats,
      [&options](const ReadyAt& where) -> Result<void> {
        // At the end it would be too late to choose another.
        if (!options.stats.empty()) {
          if (auto can = check_writable(options.stats); !can) return can;
        }
        return print_now("listening on " + where.address +
                         (where.owner_token.empty() ? "" : " " + where.owner_token) + "\n" +
                         (where.web.empty() ? "" : "web on " + where.web + "\n"));
      },
      [&options](const std::stop_token& stop) { return load_repertoire(options, stop); });
  if (!served) return report(served.error());
  int exit_code = served->error ? report(*served->error) : 0;
  if (!options.stats.empty()) {
    const auto written = write_file_atomically(options.stats, stats.to_json());
    if (!written) exit_code = report(written.error());
  }
  return exit_code;
}

int convert(std::vector<std::string> arguments) {
  bool progress = false;
  const auto say = [&progress](const std::string& text) {
    progress = true;
    std::fprintf(stderr, "\r%s\033[K", printable(text).c_str());
  };
  const bool seen = ::isatty(STDERR_FILENO) != 0;
  const auto converted = run_convert(std::move(arguments), seen ? SayProgress(say) : nullptr);
  if (progress) std::fputs("\r\033[K", stderr);
  if (!converted) return report(converted.error());
  if (const auto printed = print_now(converted->text); !printed) return report(printed.error());
  std::fputs(converted->said.c_str(), stderr);
  return 0;
}

}  // namespace

int run_transmitter(std::vector<std::string> arguments) {
  ignore_file_size_signal();
  if (!arguments.empty() && arguments.front() == "convert") {
    arguments.erase(arguments.begin());
    return convert(std::move(arguments));
  }
  // For the build, which installs both.
  if (arguments == std::vector<std::string>{"--help-man"}) {
    const auto printed = print_now(manual_page());
    return printed ? 0 : report(printed.error());
  }
  if (const auto script = completion(arguments)) {
    const auto printed = print_now(*script);
    return printed ? 0 : report(printed.error());
  }
  const auto command = read_command_line(std::move(arguments), surroundings_of_process());
  if (!command) return report(command.error());
  if (!command->text.empty()) {
    const auto printed = print_now(command->text);
    return printed ? 0 : report(printed.error());
  }
  const TransmitterOptions& options = command->options;
  const LogFormat format = options.log_format == "json" ? LogFormat::Json : LogFormat::Text;
  if (auto log = set_up_log("au-transmitter", options.log_level, format); !log)
    return report(log.error());

  if (auto can = check_sources(options); !can) return report(can.error());
  if (options.check || options.estimate) return check(options);
  auto loaded = load_repertoire(options);
  if (!loaded) return report(loaded.error());
  return serve_until_signal(options, std::move(loaded->repertoire));
}

}  // namespace aucast::server
