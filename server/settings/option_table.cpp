#include "server/settings/option_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace aucast::server {
namespace {

using Kind = OptionRow::Kind;

/// A day: longer waits for one answer are taken for a slip of the finger.
constexpr double kClientTimeoutMax = 86'400;

/// More than a process can have descriptors.
constexpr std::int64_t kMaxClientsMost = 1'000'000;

Complaint read_client_timeout(const std::string& word, TransmitterOptions& options) {
  const auto seconds = number_of<double>(word);
  if (!seconds || !(*seconds >= 0 && *seconds <= kClientTimeoutMax)) {
    return "is not a number of seconds from 0 (never) to 86400";
  }
  options.client_timeout = Milliseconds(std::llround(std::ceil(*seconds * 1000)));
  return std::nullopt;
}

Complaint read_log_level(const std::string& word, TransmitterOptions& options) {
  constexpr std::array kLevels{"trace", "debug", "info", "warning", "error", "off"};
  if (std::find(kLevels.begin(), kLevels.end(), word) == kLevels.end()) {
    return "is not one of trace, debug, info, warning, error, off";
  }
  options.log_level = word;
  return std::nullopt;
}

Complaint read_http(const std::string& word, TransmitterOptions& options) {
  const std::size_t colon = word.rfind(':');
  HttpAddress http;
  if (colon == std::string::npos || colon == 0 ||
      read_whole(std::string_view(word).substr(colon + 1), 0, 65535, http.port)) {
    return "is not ADDR:PORT, such as 127.0.0.1:9465";
  }
  http.address = word.substr(0, colon);
  options.http = http;
  return std::nullopt;
}

Complaint read_log_format(const std::string& word, TransmitterOptions& options) {
  if (word != "text" && word != "json") return "is neither text nor json";
  options.log_format = word;
  return std::nullopt;
}

template <bool TransmitterOptions::*member>
Complaint read_flag(const std::string& word, TransmitterOptions& options) {
  if (word != "true" && word != "false") return "is neither true nor false";
  options.*member = word == "true";
  return std::nullopt;
}

template <auto TransmitterOptions::*member>
Complaint read_text(const std::string& word, TransmitterOptions& options) {
  options.*member = word;
  return std::nullopt;
}

template <Complaint (*read)(const std::string&, SourceOptions&)>
Complaint of_source(const std::string& word, TransmitterOptions& options) {
  return read(word, options.source);
}

template <Complaint (*read)(const std::string&, SignalOptions&)>
Complaint of_signal(const std::string& word, TransmitterOptions& options) {
  return read(word, options.source.signal);
}

constexpr OptionRow kTable[] = {
    {"source", "", Kind::Words, "", "files, recordings, folders; - (stdin), FIFOs are live",
     "A stream file, or a recording of an AU recogniser, told by what is in it, or a folder: its "
     ".txt and .csv files are sources then, by name. A stream's name is its file's name without "
     "the extension; a client that names none, and every classic one, gets the first. - (named "
     "live) and FIFOs are sent as they are written, each keyframe to all clients at once.",
     [](const std::string& word, TransmitterOptions& options) -> Complaint {
       options.sources.emplace_back(word);
       return std::nullopt;
     },
     "Sources"},
    {"follow", "", Kind::Flag, "false", "files too are live: what is written to them from now on",
     "What a file holds already is past; its last keyframe is where the face begins. A file that "
     "is rewritten, replaced or got shorter is read anew.",
     [](const std::string& word, TransmitterOptions& options) {
       return read_follow(word, options.live_source);
     }},
    {"source-timeout", "S", Kind::Number, "10", "a live source silent so long ends (10; 0: never)",
     "Seconds, to 86400. The face holds for 0.5 s, goes to neutral in 1 s, and after this time the "
     "clients that are there get {-2}; when the source comes back, the stream goes on. Lines of a "
     "stream file hold until their input ends.",
     [](const std::string& word, TransmitterOptions& options) {
       return read_source_timeout(word, options.live_source);
     }},
    {"record", "FILE", Kind::Word, "", "keep what a live source sends (a stream file)",
     "Written as it is served, with its times; the file is whole at any moment and brought to the "
     "disk every second. Of several live sources the first is kept; in a folder each gets "
     "NAME-TIME.txt. A file that holds anything is never written over. A full disk ends the "
     "recording and not the stream; the exit code is 1 then. convert --mend reads what a power cut "
     "tore.",
     read_text<&TransmitterOptions::record>},
    {"skip-bad", "", Kind::Flag, "false", "leave out sources that are broken and say so",
     "Without it one broken source ends the start with 3 or 4, and on SIGHUP nothing is changed. "
     "When no source is left it ends all the same.",
     read_flag<&TransmitterOptions::skip_bad>},
    {"check", "", Kind::Flag, "false", "only say what they hold",
     "Prints what the sources hold (format, scale, people, duration, AUs with range, gaps) and "
     "serves nothing. Ends with 0 when all of them can be served.",
     nullptr},
    {"estimate", "", Kind::Flag, "false", "only say bits a second",
     "Prints bytes and bits a second of each level, on average and in the second that needs most, "
     "without and with headers, and serves nothing.",
     nullptr},
    {"rate", "HZ", Kind::Number, "", "keyframes a second",
     "So many keyframes a second, 0.1 to 1000, in straight lines between those there are.",
     of_source<read_rate>, "Signals of recognisers"},
    {"fps", "N", Kind::Number, "", "pictures a second",
     "Pictures a second of recordings without times, or with wrong ones.", of_source<read_fps>},
    {"au-scale", "S", Kind::Number, "auto", "1, 5, 100 (auto)",
     "What full intensity is in recordings: 1, 5, 100 or auto.", of_source<read_au_scale>},
    {"min-confidence", "C", Kind::Number, "0.5", "0 to 1 (0.5)",
     "Rows of recordings that are less sure are no data, 0 to 1: the face holds for half a second, "
     "then goes to neutral in one.",
     of_source<read_min_confidence>},
    {"face-id", "N", Kind::Number, "", "one face, or all",
     "Which face of several; without it the most frequent of a recording, and of a live source the "
     "first that is seen. With all, each is a stream of its own, STEM-FACE such as webcam-0: of a "
     "recording the most frequent comes first, 64 at most; of a live source a face's stream begins "
     "when it is first seen, 16 at most, after the one without a number, which is there from the "
     "beginning and follows one of them.",
     of_source<read_face_id>},
    {"distance", "", Kind::Flag, "false", "the head's is AUs 57, 58",
     "OpenFace's distance of the head from the camera becomes AUs 57 (forward) and 58 (back), 100 "
     "% for 14 mm, compared with the neutral face's or, without one, with the first second's. "
     "Heads move by more than that: with --gain 57=0.1,58=0.1 it is 14 cm.",
     of_signal<read_distance>},
    {"neutral", "SECONDS", Kind::Number, "", "the first seconds' median face is taken off",
     "Up to 60 seconds from the first row with a face on: the median of each AU and of the turns "
     "of head and eyes is the neutral face, and is taken off from the first row to the last. A "
     "live source takes off the median so far while it measures. 0: no neutral face, whatever the "
     "profile says.",
     of_signal<read_neutral>},
    {"gain", "LIST", Kind::Number, "", "times so much: 1.2, or 45=1.6,L12=1.2 (1)",
     "Numbers from 0 to 10 with commas between them: one alone is for every AU, 45=1.6 for AU 45, "
     "L12=1.2 for one side of AU 12; the later one wins. Applied after the neutral face was taken "
     "off; what goes beyond 100 % is 100 %.",
     of_signal<read_gain>},
    {"filter", "CUTOFF[,BETA]", Kind::Number, "", "One Euro filter, such as 1,5 (none)",
     "CUTOFF[,BETA[,CUTOFF]]: the cutoff in Hz of what stands still, above 0 to 100; how many Hz "
     "more a speed of 100 % a second makes it, 0 to 100 (5); the cutoff of the speed in Hz (1). "
     "Less cutoff is smoother, more beta less late. Casiez, Roussel and Vogel 2012. 0: no filter, "
     "whatever the profile says.",
     of_signal<read_filter>},
    {"dead-band", "LIST", Kind::Number, "", "smaller changes are not sent: 2, or 2,45=0 (2)",
     "Whole percents from 0 to 50, for every AU or for some, as --gain has them; every AU has 2 "
     "unless it is told otherwise. What trembles costs half of the bytes. An intensity stays what "
     "it was until it has changed by so much, so it is off by less than that, and what goes to 0 "
     "does so at once. 0 sends everything. Stream files and convert are never touched.",
     of_signal<read_dead_band>},
    {"profile", "FILE", Kind::Word, "", "all these of a person",
     "Neutral face, gain, dead band and filter of one person before one camera, as --save-profile "
     "writes them (TOML); the options above win over it. Read again on SIGHUP, for live sources "
     "too.",
     of_signal<read_profile_name>},
    {"save-profile", "FILE", Kind::Word, "", "and into a file",
     "Writes what the profile and the options come to, whole or not at all: with --neutral, when "
     "the neutral face has been measured, which takes one source of a recogniser; else at the "
     "start. Next time --profile FILE is enough.",
     of_signal<read_save_profile>},
    {"keyframe", "MS", Kind::Number, "250", "time of untimed keyframes (250)",
     "Milliseconds from 1 to 3600000. Clients are told in the hello, and --live goes by it.",
     [](const std::string& word, TransmitterOptions& options) {
       return read_whole(word, 1, protocol::kDurationMsMax, options.keyframe_ms);
     },
     "Sending"},
    {"classic-min", "PERCENT", Kind::Number, "20",
     "classic clients get no AU weaker than this (20)",
     "Clients of level 1 know no intensities: what is weaker is left out for them, the rest is "
     "sent as if it were whole.",
     [](const std::string& word, TransmitterOptions& options) {
       return read_whole(word, 0, 100, options.classic_min);
     }},
    {"loop", "", Kind::Flag, "false", "start again at the end",
     "After the last keyframe comes the first, without end.", read_flag<&TransmitterOptions::loop>},
    {"live", "", Kind::Flag, "false", "late comers join now",
     "All clients see the same moment. The clocks begin when the transmitter is ready. Who is slow "
     "gets the newest keyframe and misses those in between, which are counted as merged.",
     read_flag<&TransmitterOptions::live>},
    {"max-bitrate", "KBITS", Kind::Number, "0", "a second for each client, with headers (0: any)",
     "Keyframes that come too soon are merged into the next one that fits: the newest wins and "
     "takes the time of all of them, so the stream keeps its length. 1 to 1000000 kilobits; "
     "counted are packets of level 2 with 52 bytes of TCP and IP headers each. --check and "
     "--estimate show what is left. A keyframe of a source that is still being written waits until "
     "there are bits for it, and a newer one takes its place.",
     [](const std::string& word, TransmitterOptions& options) {
       return read_whole(word, 0, 1'000'000, options.max_kbits);
     }},
    {"batch", "MS", Kind::Number, "0", "small writes wait so long for each other (0: none)",
     "Headers cost more than a packet: what is written within this time goes out together. 0 to "
     "1000 milliseconds; the face is that much later.",
     [](const std::string& word, TransmitterOptions& options) -> Complaint {
       int batch_ms = 0;
       if (auto wrong = read_whole(word, 0, 1000, batch_ms)) return wrong;
       options.batch = Milliseconds(batch_ms);
       return std::nullopt;
     }},
    {"bind", "ADDR", Kind::Word, "127.0.0.1", "(127.0.0.1: this host only)",
     "An address or a name of this host. 0.0.0.0 takes connections at all its IPv4 addresses, :: "
     "at all of both kinds. The default lets nobody in from outside.",
     read_text<&TransmitterOptions::bind>, "Connections"},
    {"port", "N", Kind::Number, "4650", "(4650; 0: any free one)",
     "The TCP port. With 0 the system chooses one; the line \"listening on\" says which.",
     [](const std::string& word, TransmitterOptions& options) {
       return read_whole(word, 0, 65535, options.port);
     }},
    {"client-timeout", "S", Kind::Number, "0",
     "close those that take or answer nothing so long (0: no)",
     "Seconds, to 86400. It starts anew with every byte from the client; live, with every byte "
     "that can be sent to it. A paused client owes nothing. A host that vanished is found by TCP "
     "within a minute all the same, as is a client that takes nothing of what waits for it.",
     read_client_timeout},
    {"max-clients", "N", Kind::Number, "0", "at a time (0: any)",
     "So many at a time; 0: as many as come. A client too many gets {error 503 ...} if it says "
     "hello, and is closed. Each client takes one file descriptor; the limit of these (ulimit -n) "
     "is raised to the hard one at the start.",
     [](const std::string& word, TransmitterOptions& options) {
       return read_whole(word, 0, kMaxClientsMost, options.max_clients);
     }},
    {"max-clients-per-address", "N", Kind::Number, "0", "(0: any)",
     "So many at a time from one address; 0: as many as come. Of IPv6 the first 64 bits count as "
     "the address. Many clients behind one router have one address.",
     [](const std::string& word, TransmitterOptions& options) {
       return read_whole(word, 0, kMaxClientsMost, options.max_clients_per_address);
     }},
    {"tls-cert", "FILE", Kind::Word, "", "certificate: TLS only",
     "The certificate, and after it in the same file those of the authorities between it and one "
     "that clients know. Read again on SIGHUP, like --tls-key, --tls-client-ca and --token-file; "
     "clients that are connected stay.",
     [](const std::string& word, TransmitterOptions& options) -> Complaint {
       options.credentials.tls.certificate = word;
       return std::nullopt;
     }},
    {"tls-key", "FILE", Kind::Word, "", "its key (PEM)",
     "It should be readable for the transmitter alone.",
     [](const std::string& word, TransmitterOptions& options) -> Complaint {
       options.credentials.tls.key = word;
       return std::nullopt;
     }},
    {"tls-client-ca", "FILE", Kind::Word, "",
     "clients must show a certificate of these authorities",
     "Certificates of the authorities that clients' certificates must come from (PEM).",
     [](const std::string& word, TransmitterOptions& options) -> Complaint {
       options.credentials.tls.authorities = word;
       return std::nullopt;
     }},
    {"token-file", "FILE", Kind::Word, "", "clients must show the token in this file",
     "One word of at most 256 bytes. Who does not show it is refused before anything is told, "
     "classic clients too, which have none. Without TLS everybody on the way can read it.",
     [](const std::string& word, TransmitterOptions& options) -> Complaint {
       options.credentials.token = word;
       return std::nullopt;
     }},
    {"stats", "FILE.json", Kind::Word, "", "on exit: packets, bytes, seconds of every client",
     "Written whole or not at all. The totals count every client, the latest 1000 are listed.",
     read_text<&TransmitterOptions::stats>, "Numbers, settings, log"},
    {"http", "ADDR:PORT", Kind::Word, "", "answer /healthz, /metrics and /status.json there",
     "HTTP for a monitor: /healthz is 200 while clients are accepted and 503 while the transmitter "
     "stops, /metrics is Prometheus' text, /status.json the same as one object. GET only, one "
     "request a connection, 32 connections at a time. There is no password: keep it to this host "
     "(127.0.0.1:PORT).",
     read_http},
    {"config", "FILE", Kind::Word, "", "settings: these options as name = value (TOML)",
     "Read before the environment and the command line. Without it /etc/aucast/au-transmitter.toml "
     "is read if it is there; --config /dev/null reads none.",
     nullptr},
    {"print-config", "", Kind::Flag, "false",
     "print the settings and where each is from, and leave",
     "What is printed is a settings file that --config takes.", nullptr},
    {"log-level", "LEVEL", Kind::Word, "info", "trace ... off (info)",
     "The log goes to stderr. Of single clients it has 300 lines a second and says how many were "
     "left out; with debug it has them all.",
     read_log_level},
    {"log-format", "FORMAT", Kind::Word, "text", "or json (text)",
     "Both have the time (UTC), the level and the message. Under systemd every line begins with "
     "its priority as the journal wants it, and text leaves out what the journal knows itself.",
     read_log_format},
};

}  // namespace

std::span<const OptionRow> option_table() {
  return kTable;
}

const OptionRow* find_option(std::string_view name) {
  const auto row = std::find_if(std::begin(kTable), std::end(kTable),
                                [name](const OptionRow& other) { return other.name == name; });
  return row == std::end(kTable) ? nullptr : row;
}

std::string typed_name(const OptionRow& row) {
  return row.name == "source" ? "SOURCE" : "--" + std::string(row.name);
}

std::string variable_name(const OptionRow& row) {
  std::string name = "AUCAST_TRANSMITTER_";
  for (const char c : row.name) {
    name += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return name;
}

}  // namespace aucast::server
