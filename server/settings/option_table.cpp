#include "server/settings/option_table.h"

#include <system_error>

#include <asio/ip/address.hpp>

#include "common/standard_output.h"

namespace aucast::server {
namespace {

using Kind = OptionValue::Kind;
using Where = OptionRow::Where;

/// A day: the longest wait that can be set.
constexpr double kTimeoutMax = 86'400;
constexpr double kDrainSecondsMax = 3600;
constexpr std::string_view kNoTimeout = "is not a number of seconds from 0 (never) to 86400";

/// More descriptors than a process can have.
constexpr std::int64_t kClientsMax = 1'000'000;

Complaint read_address(const std::string& word, std::optional<HttpAddress>& address) {
  const std::size_t colon = word.rfind(':');
  const std::string host = word.substr(0, colon);
  const auto port = number_of<std::uint16_t>(std::string_view(word).substr(colon + 1));
  const bool bare_v6 = host.find(':') != std::string::npos && !host.starts_with('[');
  if (colon == std::string::npos || colon == 0 || !port || bare_v6) {
    return "is not ADDR:PORT, such as 127.0.0.1:9465 or [::1]:9465";
  }
  address = HttpAddress{host, *port};
  return std::nullopt;
}

Complaint read_proxy(const std::string& word, std::vector<std::string>& proxies) {
  std::error_code none;
  static_cast<void>(asio::ip::make_address(word, none));
  if (none) return "is not an IP address";
  proxies.push_back(word);
  return std::nullopt;
}

std::vector<OptionRow> input_rows(TransmitterOptions& options) {
  return {
      {.option = {"source", "SOURCE"},
       .text = "file, folder, film, FIFO, camera, aucast:, nats:, -",
       .more =
           "A stream file, or a recording of an AU recogniser, recognised by its content; or a "
           "folder, whose .txt and .csv files become sources, in order of their names. A stream "
           "has the name of its file without the extension; a client that asks for no name, and "
           "every classic one, gets the first. - (stdin, as a stream named live) and FIFOs are "
           "sent as they are written, each keyframe to all clients at once. "
           "aucast://HOST[:PORT][,HOST...][/NAME] is a stream of another au-transmitter, which "
           "this one relays over one connection, however many clients there are here; aucasts:// "
           "is the same over TLS. When one of several hosts is lost, the next is used. A stream "
           "that is live there is live here; a recorded one is kept, and served from its beginning "
           "even while it is still arriving, in a loop if it is in one there. SIGHUP leaves "
           "relayed streams as they are. nats://HOST[:PORT][,HOST...]/NAME is a stream that "
           "another au-transmitter sends over NATS with --publish; natss:// is the same over TLS. "
           "Both need the package aucast-nats. A film (.mp4, .mov, .mkv, .webm, .avi and others, "
           "through ffmpeg) is read for the face in it. camera is the camera /dev/video0, live, "
           "and camera:DEVICE another one; DEVICE may also be a film or a FIFO in place of a "
           "camera. Films and cameras need the models that scripts/install_models.sh fetches.",
       .value = words(options.sources),
       .heading = "Sources",
       .where = Where::Positional},
      {.option = {"follow"},
       .text = "serve a file live: send what is appended to it",
       .more = "Files are live sources too. What a file already holds is past: the face starts "
               "from its last keyframe. A file that is rewritten, replaced or truncated is read "
               "from its beginning.",
       .value = flag(options.live_source.follow)},
      {.option = {"source-timeout", "S", "10"},
       .text = "end a live source after S seconds of silence (10)",
       .more = "Seconds, up to 86400; 0: never. When the source falls silent, the face holds for "
               "0.5 s, then returns to neutral within 1 s. After S seconds of silence the "
               "connected clients get the end of the stream, {-2}; when the source comes back, the "
               "stream goes on. The lines of a stream file on stdin or a FIFO are exempt: only the "
               "end of input ends their stream.",
       .value = seconds(options.live_source.timeout, 0, kTimeoutMax, kNoTimeout)},
      {.option = {"record", "FILE"},
       .text = "keep in FILE what a live source sends",
       .more =
           "Records what is served, with its times. The file is complete at any moment and is "
           "synced to the disk every second. Of several live sources only the first is recorded; "
           "if FILE is a folder, all are, each to NAME-TIME.txt. A file that is not empty is never "
           "overwritten. A full disk ends the recording but not the stream; the exit code is 1 "
           "then. convert --mend repairs a recording that a power cut has truncated.",
       .value = word(options.record)},
      {.option = {"skip-bad"},
       .text = "leave broken sources out",
       .more = "Without this option, one broken source makes the start fail, with exit code 3 or "
               "4, or 2 if its name cannot be a stream's; and a SIGHUP that finds one changes "
               "nothing. If no source is left, the start fails even with this option.",
       .value = flag(options.skip_bad)},
      {.option = {"check"},
       .text = "describe the sources, and serve nothing",
       .more = "Prints what the sources hold (format, scale, people, duration, AUs with their "
               "ranges, gaps) and serves nothing. Ends with 0 if all of them can be served.",
       .value = flag(options.check),
       .where = Where::Typed},
      {.option = {"estimate"},
       .text = "print their bit rates, and serve nothing",
       .more = "Prints bytes and bits a second for each protocol level, on average and in the "
               "busiest second, without and with headers, and serves nothing.",
       .value = flag(options.estimate),
       .where = Where::Typed},
  };
}

std::vector<OptionRow> upstream_rows(UpstreamSettings& upstream) {
  return {
      {.option = {"upstream-token-file", "FILE"},
       .text = "the token for aucast://HOST",
       .more = "The token that the server of an aucast:// source wants, one word in a file. It is "
               "sent only over TLS or to this host.",
       .value = word(upstream.token),
       .heading = "Streams of other au-transmitters"},
      {.option = {"upstream-wait", "S", "10"},
       .text = "how long clients wait for a lost stream (10)",
       .more = "How long clients wait, with the face held, while nobody sends the stream of an "
               "aucast:// source or of --accept-push: seconds, up to 86400. After that the clients "
               "of a live stream get {-2}, and those of a recorded one that is incomplete are cut "
               "off; its servers are still tried. A client that comes before the stream waits as "
               "long, but at most 8 s, and is then refused.",
       .value =
           seconds(upstream.wait, 0, kTimeoutMax, "is not a number of seconds from 0 to 86400")},
      {.option = {"upstream-tls-ca", "FILE"},
       .text = "CAs to trust for aucasts://HOST",
       .more =
           "The certificates of authorities (PEM), one of which must have signed the certificate "
           "of an aucasts:// source's server. Without this option the system's authorities count.",
       .value = word(upstream.tls.authorities)},
  };
}

std::vector<OptionRow> engine_rows(EngineSettings& engine) {
  return {
      {.option = {"publish", "URL"},
       .text = "send the first source over NATS, live",
       .more = "Publishes the first source over NATS under NAME, and serves it all the same. It is "
               "for au-transmitters whose SOURCE is this address (protocol/ENGINE.md). "
               "nats://HOST[:PORT][,HOST...]/NAME names several servers, which are tried in their "
               "order; natss:// is over TLS. Implies --live. What comes within the time of --batch "
               "is sent together.",
       .value = word(engine.publish),
       .heading = "NATS"},
      {.option = {"nats-token-file", "FILE"},
       .text = "the token for the NATS servers",
       .more = "The token that the servers of NATS want, one word in a file. It is sent only over "
               "TLS or to this host.",
       .value = word(engine.token)},
      {.option = {"nats-login", "FILE"},
       .text = "a file with NAME:PASSWORD",
       .more = "A file whose only line is a user of NATS with the password, NAME:PASSWORD. It is "
               "sent only over TLS or to this host.",
       .value = word(engine.login)},
      {.option = {"nats-creds", "FILE"},
       .text = "a .creds file",
       .more = "The credentials of a user of NATS: a .creds file with its JWT and its seed.",
       .value = word(engine.creds)},
      {.option = {"nats-nkey", "KEY"},
       .text = "a public NKey",
       .more = "The public NKey of a user of NATS (U...), whose seed is in --nats-seed.",
       .value = word(engine.nkey)},
      {.option = {"nats-seed", "FILE"},
       .text = "the seed of that NKey",
       .more = "The seed of --nats-nkey (SU...).",
       .value = word(engine.seed)},
      {.option = {"nats-tls-ca", "FILE"},
       .text = "CAs to trust for natss://HOST",
       .more = "The certificates of authorities (PEM), one of which must have signed those of the "
               "servers of a natss:// address. Without this option the system's authorities count. "
               "A file with revocation lists is refused, since NATS' library does not heed them.",
       .value = word(engine.tls.authorities)},
      {.option = {"nats-tls-cert", "FILE"},
       .text = "the certificate to show to NATS servers",
       .more = "A certificate to show to servers of NATS that want one (PEM).",
       .value = word(engine.tls.certificate)},
      {.option = {"nats-tls-key", "FILE"},
       .text = "the private key of --nats-tls-cert",
       .more = "The private key of --nats-tls-cert (PEM).",
       .value = word(engine.tls.key)},
  };
}

std::vector<OptionRow> push_rows(PushSettings& push, CredentialFiles& credentials) {
  return {
      {.option = {"push", "URL"},
       .text = "push the stream that URL names, or the first",
       .more = "Brings a stream to another au-transmitter, which must run with --accept-push. It "
               "is dialled from here, such as from behind a home router: URL is "
               "aucast://HOST[:PORT][,HOST...][/NAME], or aucasts:// over TLS. NAME is the "
               "stream's name there. The stream that is sent is the one called NAME here or, if "
               "there is none, the first; without NAME it is the first, under its own name. When "
               "one of several hosts is lost, the next is used, and all are tried again for ever. "
               "May be repeated, for several servers or streams.",
       .value = words(push.addresses),
       .heading = "Pushing"},
      {.option = {"push-token-file", "FILE"},
       .text = "the token to push with",
       .more = "The publisher's token that the servers of --push want, one word in a file. It is "
               "sent only over TLS or to this host.",
       .value = word(push.token)},
      {.option = {"push-tls-ca", "FILE"},
       .text = "CAs to trust for aucasts:// URLs of --push",
       .more = "The certificates of authorities (PEM), one of which must have signed those of the "
               "servers of --push aucasts://. Without this option the system's authorities count.",
       .value = word(push.tls.authorities)},
      {.option = {"accept-push", "FILE"},
       .text = "serve what others push; FILE has their tokens",
       .more = "Streams that others bring by --push are served here too; a SOURCE is not needed "
               "then. FILE has one publisher a line: a token of at most 256 bytes and, after it, "
               "the names of the streams that the publisher may bring; without names, any. These "
               "tokens are not those of viewers. A name has one publisher at a time, and cannot be "
               "the name of one of this server's own streams. While a publisher is away, the "
               "clients of its stream hold for --upstream-wait. SIGHUP reads FILE again.",
       .value = word(credentials.publishers)},
  };
}

OptionRow preview_row(TransmitterOptions& options) {
  return {
      .option = {"preview"},
      .text = "write to stdout what the camera sees",
      .more =
          "For a program that starts this one: standard output tells what the camera sees, as "
          "small pictures with landmarks and AUs, and standard input takes orders to let others in "
          "or send them away. The end of standard input ends the program. Both must be pipes or "
          "sockets. The only SOURCE is a camera. Before others are let in, only who shows the "
          "token "
          "of the line \"listening on\" is served; --token-file and --tls-cert are for those who "
          "are let in. The format is in common/preview/README.md.",
      .value = flag(options.preview),
      .where = Where::Typed};
}

std::vector<OptionRow> sending_rows(TransmitterOptions& options) {
  return {
      {.option = {"keyframe", "MS", "250"},
       .text = "how long keyframes without a time last (250)",
       .more = "How long a keyframe without a time lasts, in milliseconds, 1 to 3600000. The hello "
               "tells it to clients, and --live uses it.",
       .value = whole(options.keyframe_ms, 1, protocol::kKeyframeTimeMsMax),
       .heading = "Sending"},
      {.option = {"classic-min", "PERCENT", "20"},
       .text = "weakest AU sent to level 1 (classic) clients (20)",
       .more = "For classic clients, since level 1 has no intensities: AUs weaker than this are "
               "left out, all others are sent as fully active.",
       .value = whole(options.classic_min, 0, 100)},
      {.option = {"loop"},
       .text = "start again at the end",
       .more = "The first keyframe follows the last, endlessly.",
       .value = flag(options.loop)},
      {.option = {"live"},
       .text = "play recordings on one clock for all clients",
       .more = "All clients see the same moment. Time starts when the transmitter is ready. A slow "
               "client gets the newest keyframe and misses those in between; the statistics count "
               "them as merged.",
       .value = flag(options.live)},
      {.option = {"max-bitrate", "KBITS", "0"},
       .text = "limit of kbit/s to each client (0: none)",
       .more = "Kilobits a second for each client, headers included, up to 1000000. The voice is "
               "subtracted first. Keyframes that come too soon are merged into the next one that "
               "fits: only the newest is sent, with the time of all of them, so the stream keeps "
               "its length. Level 2 packets count with 52 bytes of TCP and IP headers each. "
               "--check and --estimate show the result. A keyframe of a live source waits until it "
               "fits, and a newer one replaces it.",
       .value = whole(options.max_kbits, 0, 1'000'000)},
      {.option = {"batch", "MS", "0"},
       .text = "hold packets up to MS, send them together (0: no)",
       .more = "Most packets are smaller than their TCP and IP headers, so what is written within "
               "this time, up to 1000 milliseconds, goes out together. The face is delayed by up "
               "to as much.",
       .value = whole(options.batch, 0, 1000)},
  };
}

std::vector<OptionRow> connection_rows(TransmitterOptions& options) {
  return {
      {.option = {"bind", "ADDR", "127.0.0.1"},
       .text = "address to listen on (127.0.0.1: this host only)",
       .more = "An address or a name of this host. 0.0.0.0 listens on all IPv4 addresses, :: on "
               "all IPv4 and IPv6 addresses. The default admits nobody from outside.",
       .value = word(options.bind),
       .heading = "Connections"},
      {.option = {"port", "N", "4650"},
       .text = "port to listen on (4650; 0: any free one)",
       .more =
           "The TCP port. With 0 the system chooses one; the line \"listening on\" tells which.",
       .value = whole(options.port, 0, 65535)},
      {.option = {"reuse-port"},
       .text = "share the port with other au-transmitters",
       .more = "Several au-transmitters of one user, all with this option, listen on the same port "
               "(and on those of --web and --http), and the system spreads clients over them. "
               "Start one for each processor core, or the next version beside this one. What they "
               "serve should be the same: recordings, or streams that each relays. Each counts its "
               "own clients and limits.",
       .value = flag(options.reuse_port)},
      {.option = {"drain-time", "S", "0"},
       .text = "at exit, give clients S seconds to move elsewhere (0)",
       .more = "At SIGTERM or SIGINT no new clients are accepted. Within S seconds, up to 3600, "
               "clients of level 2 are cut off one by one, without {-2}, so that those with "
               "--reconnect, relays and web pages go on with another au-transmitter at this "
               "address, such as the next version with --reuse-port; a recorded stream resumes "
               "where it was. Whoever is left after S seconds gets {-2}. A second signal, or S = "
               "0, sends {-2} to all at once.",
       .value = seconds(options.drain_time, 0, kDrainSecondsMax,
                        "is not a number of seconds from 0 to 3600")},
      {.option = {"client-timeout", "S", "0"},
       .text = "drop clients silent for S seconds (0: never)",
       .more = "Disconnects a client that owes an answer to a keyframe and sends no byte for S "
               "seconds, up to 86400. A client that takes no byte for as long is disconnected too, "
               "if its stream is live or if it has sent its answers in advance. The time does not "
               "run while a client is paused, nor before its stream begins. TCP detects a vanished "
               "host, and a client that stops reading, within a minute anyway.",
       .value = seconds(options.client_timeout, 0, kTimeoutMax, kNoTimeout)},
      {.option = {"max-clients", "N", "0"},
       .text = "at most N clients (0: as the system allows)",
       .more = "The number of clients at a time; one that has got {-2} counts until it has closed "
               "its connection. One client too many is closed, with {error 503 ...} if it sent a "
               "hello. 0 allows the smaller of two numbers: the file descriptors less 128, and the "
               "memory that is free at the start divided by 64 KiB. The soft limit of descriptors "
               "(ulimit -n) is raised to the hard limit at the start.",
       .value = whole(options.max_clients, 0, kClientsMax)},
      {.option = {"max-clients-per-address", "N", "0"},
       .text = "at most N from one address (0: any number)",
       .more = "The number of clients at a time from one address; of an IPv6 address the first 64 "
               "bits count. Clients behind one router share an address.",
       .value = whole(options.max_clients_per_address, 0, kClientsMax)},
  };
}

std::vector<OptionRow> credential_rows(CredentialFiles& files) {
  return {
      {.option = {"tls-cert", "FILE"},
       .text = "serve over TLS with this certificate",
       .more = "The certificate, followed in the same file by those of the intermediate "
               "authorities (PEM). SIGHUP reads it again, as it does --tls-key, --tls-client-ca, "
               "--web-cert, --web-key, --token-file and --accept-push; connected clients stay.",
       .value = word(files.tls.certificate),
       .heading = "TLS and tokens"},
      {.option = {"tls-key", "FILE"},
       .text = "the private key of --tls-cert",
       .more = "PEM. Only the transmitter should be able to read it.",
       .value = word(files.tls.key)},
      {.option = {"tls-client-ca", "FILE"},
       .text = "require client certificates signed by these CAs",
       .more = "Clients must show a certificate that one of these authorities has signed (PEM). If "
               "the file has revocation lists too, a client whose certificate is in one is "
               "refused, and so is one whose authority's list is missing or out of date. Only the "
               "client's own certificate is looked up, not those of intermediate authorities.",
       .value = word(files.tls.authorities)},
      {.option = {"token-file", "FILE"},
       .text = "the token that viewers must show",
       .more = "One word of at most 256 bytes. A client without it is refused before it learns "
               "anything, and so is every classic client, which cannot send one. Without TLS "
               "anyone on the path can read it.",
       .value = word(files.token)},
  };
}

std::vector<OptionRow> web_rows(WebOptions& web, tls::Files& files) {
  return {
      {.option = {"web", "ADDR:PORT"},
       .text = "serve the page for browsers at http://ADDR:PORT/",
       .more = "Serves the player as a web page at http://ADDR:PORT/, and the protocol over "
               "WebSocket at /aucast there. The line \"web on ADDR:PORT\" follows \"listening on\" "
               "when the page is ready. --max-clients, --token-file and all other limits hold for "
               "its viewers as well. Without --web-cert, viewers on other hosts should come "
               "through a proxy that speaks https.",
       .value = parsed(Kind::Word, read_address, web.address),
       .heading = "Page for browsers"},
      {.option = {"web-cert", "FILE"},
       .text = "serve the page over https with this certificate",
       .more = "The certificate for --web, followed in the same file by those of the intermediate "
               "authorities (PEM): https and wss in place of http and ws. SIGHUP reads it again.",
       .value = word(files.certificate)},
      {.option = {"web-key", "FILE"},
       .text = "the private key of --web-cert",
       .more = "The private key of --web-cert (PEM).",
       .value = word(files.key)},
      {.option = {"web-host", "NAME"},
       .text = "a further host name of the page",
       .more = "A host name under which --web may be reached, beside IP addresses, localhost and "
               "the names of --web-cert: its own, or that of a proxy in front of it. Pages of "
               "these hosts may watch by WebSocket too, such as a course page that holds a face. "
               "*.NAME stands for NAME with one more label before it. May be repeated.",
       .value = words(web.hosts)},
      {.option = {"web-trusted-proxy", "ADDR"},
       .text = "believe X-Forwarded-For of this reverse proxy",
       .more = "The IP address of a reverse proxy. For its requests, the last address in "
               "X-Forwarded-For is taken as the client's, in --max-clients-per-address and in the "
               "log. May be repeated.",
       .value = parsed(Kind::Words, read_proxy, web.trusted_proxies)},
  };
}

std::vector<OptionRow> status_rows(TransmitterOptions& options) {
  return {
      {.option = {"stats", "FILE.json"},
       .text = "write statistics at exit; - for stdout",
       .more = "Writes totals over all clients, and a list of the latest 1000 with statistics of "
               "each. The file is written completely or not at all.",
       .value = parsed(Kind::Word, read_output_path, options.stats),
       .heading = "Status, settings, log"},
      {.option = {"http", "ADDR:PORT"},
       .text = "serve status and metrics for monitors",
       .more = "HTTP for monitoring: /healthz is 200 while clients are accepted and 503 while the "
               "transmitter stops, /metrics is in Prometheus' text format, /status.json has the "
               "same as one object. Only GET, one request for each connection, 32 connections at a "
               "time. There is no password: keep it to this host (127.0.0.1:PORT).",
       .value = parsed(Kind::Word, read_address, options.http)},
  };
}

std::vector<OptionRow> program_rows(TransmitterOptions& options) {
  return {
      {.option = {"config", "FILE"},
       .text = "read settings from FILE (TOML)",
       .more =
           "FILE has these options as name = value, one per line. It is read before the "
           "environment and the command line, which win over it. Without this option "
           "/etc/aucast/au-transmitter.toml is read if it exists; --config /dev/null reads none.",
       .where = Where::Typed},
      {.option = {"print-config"},
       .text = "print all settings, and where each comes from",
       .more = "Prints each setting, and where it comes from. The output is a settings file for "
               "--config.",
       .value = flag(),
       .where = Where::Typed},
      {.option = {"log-level", "LEVEL", "info"},
       .text = "trace, debug, info, warning, error or off (info)",
       .more = "trace, debug, info, warning, error or off. The log goes to stderr. It has at most "
               "300 lines a second about clients and tells how many were left out; at debug it has "
               "them all.",
       .value = log_level(options.log_level)},
      {.option = {"log-format", "FORMAT", "text"},
       .text = "text or json (text)",
       .more =
           "Both have the time (UTC), the level and the message. Under systemd each line begins "
           "with its priority for the journal, and text omits what the journal adds itself.",
       .value = one_of(options.log_format, {"text", "json"})},
      {.option = {"verbose"},
       .text = "the same as --log-level debug",
       .more = "The same as --log-level debug. --log-level wins.",
       .value = flag(),
       .where = Where::Typed,
       .letter = 'v'},
      {.option = {"quiet"},
       .text = "the same as --log-level error",
       .more = "The same as --log-level error. --log-level wins. Not with -v.",
       .value = flag(),
       .where = Where::Typed,
       .letter = 'q'},
  };
}

}  // namespace

std::vector<OptionRow> option_rows(TransmitterOptions& options) {
  std::vector<OptionRow> rows = input_rows(options);
  append(rows, upstream_rows(options.upstream));
  append(rows, engine_rows(options.engine));
  append(rows, push_rows(options.push, options.credentials));
  append(rows, recording_rows(options.source));
  append(rows, camera_rows(options.source.camera));
  rows.push_back(preview_row(options));
  append(rows, signal_rows(options.source.signal));
  append(rows, voice_rows(options.voice));
  append(rows, sending_rows(options));
  append(rows, connection_rows(options));
  append(rows, credential_rows(options.credentials));
  append(rows, web_rows(options.web, options.credentials.web));
  append(rows, status_rows(options));
  append(rows, program_rows(options));
  append(rows, help_rows());
  return rows;
}

CommandPage transmitter_page() {
  TransmitterOptions described;
  return {
      .program = "au-transmitter",
      .usage = {"au-transmitter [OPTIONS] SOURCE...", "au-transmitter convert --help"},
      .about = "Streams FACS Action Units over TCP to face-player and other clients.\n",
      .rows = unbound(option_rows(described)),
      .notes =
          R"(Settings file, then AUCAST_TRANSMITTER_<OPTION>, then command line: last wins.
Prints "listening on ADDR:PORT" when ready; logs to stderr; Ctrl-C ends it.
SIGHUP reloads the sources, SIGUSR1 logs the status. In parentheses: defaults.
Exit codes: 0 done, 1 failed, 2 usage, 3 bad data, 4 unreadable, 5 network.
)",
      .examples = {"au-transmitter talk.txt",
                   "printf '1111111-4' | nc 127.0.0.1 4650   (prints its first eight packets)",
                   "au-transmitter --bind 0.0.0.0 --live --loop talk.txt",
                   "au-transmitter aucast://origin.example.org/talk     (a relay of that stream)"}};
}

}  // namespace aucast::server
