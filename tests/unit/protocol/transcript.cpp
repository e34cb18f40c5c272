#include "tests/unit/protocol/transcript.h"

#include <algorithm>
#include <charconv>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>

#include "common/text.h"
#include "protocol/base64.h"
#include "protocol/client_session.h"
#include "protocol/codec.h"
#include "protocol/limits.h"
#include "protocol/live_replay.h"
#include "protocol/publish_session.h"
#include "protocol/publishers.h"
#include "protocol/server_session.h"
#include "tests/unit/protocol/session_text.h"

namespace aucast::test {

using namespace protocol;

namespace {

struct Line {
  std::size_t number = 0;
  std::string verb;  ///< "C>", "S stops", "t", ...
  std::string rest;
};

int number_of(std::string_view text) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// "C>" and "S>" are one word, "C ends" two; the set-up words and "t" are one.
std::vector<Line> lines_of(std::string_view transcript) {
  std::vector<Line> lines;
  std::istringstream text{std::string(transcript)};
  std::string line;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    std::size_t end = std::min(line.find(' '), line.size());
    if (line.starts_with("C ") || line.starts_with("S ")) {
      end = std::min(line.find(' ', end + 1), line.size());
    }
    lines.push_back({number, line.substr(0, end), line.substr(std::min(end + 1, line.size()))});
  }
  return lines;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string at(const Line& line, const std::string& reason) {
  return "line " + std::to_string(line.number) + ": " + reason;
}

/// What one side has said and the transcript has not mentioned yet.
class Said {
 public:
  void add(std::string_view bytes) { bytes_ += bytes; }
  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] std::string text() const { return escaped(bytes_, 200); }
  bool take(std::string_view expected) {
    if (!std::string_view(bytes_).starts_with(expected)) return false;
    bytes_.erase(0, expected.size());
    return true;
  }

 private:
  std::string bytes_;
};

/// `voice PLACE DATA...`, `caption PLACE TEXT`: to be heard and read with the stream before.
void add_spoken(ServedStream& stream, const Line& line, const std::vector<std::string>& words) {
  auto& recorded = std::get<RecordedStream>(stream.kind);
  SpokenTrack spoken = recorded.spoken ? *recorded.spoken : SpokenTrack{};
  const int place = number_of(words.front());
  if (line.verb == "caption") {
    spoken.captions.push_back(
        {static_cast<std::uint64_t>(place),
         line.rest.substr(std::min(words.front().size() + 1, line.rest.size()))});
  } else {
    EncodedTrack track = spoken.voice ? *spoken.voice : EncodedTrack{};
    Milliseconds at(place);
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string opus = from_base64(words[i]).value_or("");
      track.add({at, opus});
      at += opus_duration(opus).value_or(Milliseconds{0});
    }
    track.finish();
    spoken.voice = std::make_shared<const EncodedTrack>(std::move(track));
  }
  recorded.spoken = std::make_shared<const SpokenTrack>(std::move(spoken));
}

/// `publisher TOKEN [NAME...]`; the name `taken` is another's already.
void add_publisher(ServerCatalogue& catalogue, std::vector<std::string> words) {
  std::vector<Publishers::Publisher> all;
  if (catalogue.publishers) all = catalogue.publishers->all();
  all.push_back({words.front(), {words.begin() + 1, words.end()}});
  catalogue.publishers = std::make_shared<const Publishers>(std::move(all));
  catalogue.publish_refused = [](const HelloAsked& hello) -> std::optional<ErrorReply> {
    if (hello.publish != "taken") return std::nullopt;
    return ErrorReply{409, "another publisher sends the stream 'taken'"};
  };
}

/// The names of the transcript's set-up: what is served.
ServerCatalogue catalogue_of(const std::vector<Line>& lines) {
  ServerCatalogue catalogue;
  for (const Line& line : lines) {
    if (line.verb == "loop") catalogue.loop = true;
    if (line.verb == "token") catalogue.token = line.rest;
    if (line.verb == "title") catalogue.streams.back().title = line.rest;
    if (line.verb == "publisher") add_publisher(catalogue, words_of(line.rest));
    if (line.verb == "voice" || line.verb == "caption") {
      add_spoken(catalogue.streams.back(), line, words_of(line.rest));
    }
    if (line.verb != "stream") continue;
    const std::vector<std::string> words = words_of(line.rest);
    std::vector<Keyframe> keyframes;
    for (std::size_t i = 1; i < words.size(); ++i) {
      Keyframe keyframe;
      const std::string& packet = words[i];
      (void)parse_keyframe(std::string_view(packet).substr(1, packet.size() - 2), TermSyntax::Wire,
                           keyframe);
      keyframes.push_back(std::move(keyframe));
    }
    catalogue.streams.push_back(served(words.front(), encoded(keyframes, 20)));
  }
  if (catalogue.streams.empty())
    catalogue.streams = {served("talk", encoded({"{1}", "{2}", "{3}"}))};
  return catalogue;
}

Silence silence_of(const std::vector<Line>& lines) {
  const bool refused = std::any_of(lines.begin(), lines.end(),
                                   [](const Line& line) { return line.verb == "websocket"; });
  return refused ? Silence::Refused : Silence::Classic;
}

class ServerReplay {
 public:
  explicit ServerReplay(const std::vector<Line>& lines)
      : lines_(lines),
        catalogue_(catalogue_of(lines)),
        live_(make_live(lines, catalogue_)),
        session_(catalogue_, {}, now_, Admission::Welcome, {}, silence_of(lines)) {}

  std::string run() {
    for (const Line& line : lines_) {
      std::string fault = play(line);
      if (!fault.empty()) return at(line, fault);
    }
    return left_over();
  }

 private:
  std::string play(const Line& line) {
    if (line.verb == "S>") {
      if (said_.take(unescaped(line.rest))) return {};
      return "the server said '" + said_.text() + "'";
    }
    if (line.verb == "S end") return expect(std::exchange(shut_, false), "no end of sending");
    if (line.verb == "S closes") {
      const std::string closed = std::exchange(closed_, {});
      return expect(closed == line.rest, "the server closed '" + closed + "'");
    }
    if (line.verb == "S hands") return expect(std::exchange(handed_over_, false), "it does not");
    if (line.verb == "S is") return expect(state() == line.rest, "the server is " + state());
    return input(line);
  }

  std::string input(const Line& line) {
    const bool acts = line.verb == "C>" || line.verb == "C end" || line.verb == "C breaks" ||
                      line.verb == "t" || line.verb == "S stops";
    if (!acts) return {};
    std::string fault = left_over();
    if (!fault.empty()) return fault;
    if (line.verb == "C>") take(session_.on_bytes(unescaped(line.rest), now_));
    if (line.verb == "C end" || line.verb == "C breaks") {
      client_ended_ = true;
      if (!draining_.empty()) end_drain();
    }
    if (line.verb == "C end") take(session_.on_peer_end(now_));
    if (line.verb == "C breaks") take(session_.on_lost(now_));
    if (line.verb == "S stops") take(session_.stop(now_));
    if (line.verb == "t") pass(Milliseconds(number_of(line.rest)));
    return {};
  }

  /// The first stream, if it is to be live.
  static std::shared_ptr<LiveReplay> make_live(const std::vector<Line>& lines,
                                               ServerCatalogue& catalogue) {
    const bool live = std::any_of(lines.begin(), lines.end(),
                                  [](const Line& line) { return line.verb == "live"; });
    if (!live) return nullptr;
    ServedStream& first = catalogue.streams.front();
    auto replay = std::make_shared<LiveReplay>(first.recorded()->encoded, catalogue.loop, Instant{},
                                               first.recorded()->spoken);
    replay->advance(Instant{});
    first.kind = replay;
    return replay;
  }

  void pass(Milliseconds time) {
    const Instant until = now_ + time;
    while (live_ && live_->next_at() && *live_->next_at() <= until) {
      now_ = std::max(now_, *live_->next_at());
      take(session_.on_time(now_));
      if (live_->advance(now_)) take(session_.on_moment(now_));
    }
    now_ = until;
    take(session_.on_time(now_));
    if (!draining_.empty() && now_ >= drained_at_) end_drain();
  }

  static std::string expect(bool holds, const std::string& otherwise) {
    return holds ? std::string() : otherwise;
  }

  std::string left_over() const {
    if (!said_.empty()) return "the server also said '" + said_.text() + "'";
    if (shut_) return "the server also ended its sending";
    if (!closed_.empty()) return "the server also closed: " + closed_;
    if (handed_over_) return "the server also handed over";
    return {};
  }

  std::string state() const {
    const std::string level = session_.level() == Level::Classic ? "classic" : "level-2";
    if (session_.paused()) return level + " paused";
    return level + (session_.awaiting_answer() ? " awaiting" : " idle");
  }

  void take(const std::vector<ServerEvent>& events) {
    for (const ServerEvent& event : events) {
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        said_.add(send->bytes);
      } else if (const auto* close = std::get_if<CloseConnection>(&event)) {
        drain(*close);
      } else {
        handed_over_ = true;
      }
    }
  }

  /// What the link does: after the last packet it reads on (section 8).
  void drain(const CloseConnection& close) {
    using Why = CloseConnection::Why;
    shut_ = close.why == Why::Finished || close.why == Why::Stopped || close.why == Why::Refused;
    if (shut_ && !client_ended_) {
      draining_ = name(close.why);
      drained_at_ = now_ + kDrainTimeMax;
    } else {
      closed_ = name(close.why);
    }
  }

  void end_drain() { closed_ = std::exchange(draining_, {}); }

  const std::vector<Line>& lines_;
  ServerCatalogue catalogue_;
  Instant now_{};
  std::shared_ptr<LiveReplay> live_;
  ServerSession session_;
  Said said_;
  bool shut_ = false;
  bool client_ended_ = false;
  std::string draining_;  ///< why it will be closed at the end of the drain
  Instant drained_at_{};
  std::string closed_;
  bool handed_over_ = false;
};

ClientSessionOptions options_of(const std::vector<Line>& lines) {
  ClientSessionOptions options;
  for (const Line& line : lines) {
    if (line.verb != "client") continue;
    for (const std::string& word : words_of(line.rest)) {
      if (word == "classic") options.negotiate = false;
      if (word == "delta") options.hello.delta = true;
      if (word == "voice") options.hello.voice = kVoiceCodec;
      if (word == "text") options.hello.text = true;
      if (word == "loop") options.hello.loop = true;
      if (word == "takes") options.hello.takes = true;
      if (word.starts_with("window=")) {
        options.hello.window = number_of(std::string_view(word).substr(7));
      }
      if (word.starts_with("stream=")) options.hello.stream = word.substr(7);
      if (word.starts_with("token=")) options.hello.token = word.substr(6);
      if (word.starts_with("from=")) {
        options.hello.from_ms = static_cast<std::uint64_t>(number_of(word.substr(5)));
      }
    }
  }
  return options;
}

class ClientReplay {
 public:
  explicit ClientReplay(const std::vector<Line>& lines)
      : lines_(lines), session_(options_of(lines)) {
    take(session_.on_connected(now_));
  }

  std::string run() {
    for (const Line& line : lines_) {
      std::string fault = play(line);
      if (!fault.empty()) return at(line, fault);
    }
    if (!said_.empty()) return "at the end: the client also said '" + said_.text() + "'";
    if (stores_named_ && !stored_.empty()) return "at the end: also stored " + stored_.front();
    if (!heard_.empty()) return "at the end: also heard " + heard_.front();
    return over_.empty() ? "" : "at the end: the client also ended: " + over_;
  }

 private:
  std::string play(const Line& line) {
    if (line.verb == "S>") take(read_all(session_, unescaped(line.rest)));
    if (line.verb == "S end") take(session_.on_closed());
    if (line.verb == "t") {
      now_ += Milliseconds(number_of(line.rest));
      take(session_.on_time(now_));
    }
    if (line.verb == "C pauses") said_.add(session_.pause());
    if (line.verb == "C resumes") said_.add(session_.resume());
    if (line.verb == "C>") return say(unescaped(line.rest));
    if (line.verb == "C stores") return expect_stored(line.rest);
    if (line.verb == "C hears" || line.verb == "C reads") {
      const std::string sound = heard_.empty() ? "nothing" : heard_.front();
      if (!heard_.empty()) heard_.pop_front();
      return sound == line.rest ? std::string() : "the client has " + sound;
    }
    if (line.verb == "C ends") {
      const std::string over = std::exchange(over_, {});
      return over == line.rest ? std::string() : "the client ended '" + over + "'";
    }
    if (line.verb == "C is" && state() != line.rest) return "the client is " + state();
    return {};
  }

  /// Codes are said by the owner's hand; a hello has been said by the session itself.
  std::string say(const std::string& expected) {
    if (said_.empty()) {
      for (std::string_view rest = expected; !rest.empty();) {
        const std::string_view code = rest.substr(0, rest.front() == '-' ? 2 : 1);
        rest.remove_prefix(code.size());
        act(code);
      }
    }
    if (said_.take(expected)) return {};
    return "the client said '" + said_.text() + "'";
  }

  void act(std::string_view code) {
    if (code == "1") said_.add(session_.answer_received());
    if (code == "-1") said_.add(session_.pause());
    if (code == "-3") said_.add(session_.resume());
    if (code == "-4") said_.add(session_.stop());
  }

  std::string expect_stored(const std::string& set) {
    stores_named_ = true;
    if (stored_.empty()) return "nothing was stored";
    const std::string first = stored_.front();
    stored_.pop_front();
    return first == set ? std::string() : "stored was " + first;
  }

  std::string state() const {
    const std::string level = session_.level() == Level::Classic ? "classic" : "level-2";
    return level + (session_.paused() ? " paused" : "") +
           " unanswered=" + std::to_string(session_.unanswered());
  }

  void take(const std::vector<ClientEvent>& events) {
    for (const ClientEvent& event : events) {
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        said_.add(send->bytes);
      } else if (const auto* keyframe = std::get_if<DeliverKeyframe>(&event)) {
        stored_.push_back(format_au_set(keyframe->aus));
      } else if (const auto* voice = std::get_if<DeliverVoice>(&event)) {
        heard_.push_back("voice at " + std::to_string(voice->packet.place.count()));
      } else if (const auto* caption = std::get_if<DeliverCaption>(&event)) {
        heard_.push_back("'" + caption->caption.text + "' at " +
                         std::to_string(caption->caption.place_ms));
      } else if (const auto* failed = std::get_if<SessionFailed>(&event)) {
        over_ = test::name_of(failed->why);
      } else if (!std::holds_alternative<Granted>(event)) {
        over_ = std::holds_alternative<StreamEnded>(event) ? "properly" : "to reconnect";
      }
    }
  }

  const std::vector<Line>& lines_;
  Instant now_{};
  ClientSession session_;
  Said said_;
  std::deque<std::string> stored_;
  std::deque<std::string> heard_;  ///< and read
  bool stores_named_ = false;
  std::string over_;
};

/// What the publisher says first is what it would say, and the answer is one that turns the roles.
std::string introduced(const std::vector<Line>& before, const std::vector<Line>& after) {
  PublishSession::Asked asked;
  std::string hello;
  std::string answer;
  for (const Line& line : before) {
    if (line.verb == "C>") hello += unescaped(line.rest);
    if (line.verb != "publish") continue;
    for (const std::string& word : words_of(line.rest)) {
      if (word.starts_with("token=")) {
        asked.token = word.substr(6);
      } else if (word.starts_with("relay=")) {
        asked.id = word.substr(6);
      } else {
        asked.stream = word;
      }
    }
  }
  for (const Line& line : after) {
    if (line.verb == "C>" && answer.empty()) answer = unescaped(line.rest);
  }
  PublishSession session(asked);
  if (session.hello() != hello) return "the publisher said '" + session.hello() + "'";
  const auto read = session.on_bytes(answer);
  if (const auto* failed = std::get_if<PublishSession::Failed>(&read)) return failed->reason;
  const auto* taken = std::get_if<PublishSession::Taken>(&read);
  return taken != nullptr && taken->bytes == answer ? "" : "the publisher did not read the answer";
}

/// Every verb that a transcript may use; a mistyped one must not pass for a comment.
std::string unknown_verb(const std::vector<Line>& lines) {
  static const std::vector<std::string> kKnown = {
      "stream",  "loop",     "live",      "client",    "for",       "C>",     "S>",    "t",
      "C end",   "C breaks", "C stores",  "C pauses",  "C resumes", "C ends", "C is",  "S end",
      "S stops", "S closes", "S hands",   "S is",      "token",     "voice",  "title", "caption",
      "C hears", "C reads",  "websocket", "publisher", "publish",   "roles"};
  for (const Line& line : lines) {
    if (std::find(kKnown.begin(), kKnown.end(), line.verb) == kKnown.end()) {
      return at(line, "'" + line.verb + "' is none of the words of a transcript");
    }
  }
  return {};
}

}  // namespace

std::string unescaped(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      bytes += text[i];
      continue;
    }
    const char kind = text[++i];
    if (kind == 'x') {
      int code = 0;
      std::from_chars(text.data() + i + 1, text.data() + std::min(i + 3, text.size()), code, 16);
      bytes += static_cast<char>(code);
      i += 2;
    } else if (kind == '*') {
      const std::size_t open = text.find('[', i);
      const std::size_t close = text.find(']', i);
      if (close == std::string_view::npos || open > close) return bytes;
      for (int n = number_of(text.substr(i + 1)); n > 0; --n) {
        bytes += text.substr(open + 1, close - open - 1);
      }
      i = close;
    } else {
      bytes += kind == 'n' ? '\n' : kind == 'r' ? '\r' : kind == 't' ? '\t' : kind;
    }
  }
  return bytes;
}

bool is_for(std::string_view transcript, std::string_view side) {
  for (const Line& line : lines_of(transcript)) {
    if (line.verb == "for") return line.rest.find(side) != std::string::npos;
  }
  return true;
}

std::string replay_on_server(std::string_view transcript) {
  const std::vector<Line> lines = lines_of(transcript);
  const std::string unknown = unknown_verb(lines);
  return unknown.empty() ? ServerReplay(lines).run() : unknown;
}

std::string replay_on_publisher(std::string_view transcript) {
  const std::vector<Line> lines = lines_of(transcript);
  if (std::string unknown = unknown_verb(lines); !unknown.empty()) return unknown;
  std::vector<Line> before;
  std::vector<Line> after;
  bool turned = false;
  for (const Line& line : lines) {
    const bool happens = line.verb.size() == 2 || line.verb.starts_with("C ") ||
                         line.verb.starts_with("S ") || line.verb == "t";
    if (line.verb == "roles") turned = true;
    if (!happens || !turned) before.push_back(line);
    if (!happens || turned) after.push_back(line);
  }
  std::string fault = ServerReplay(before).run();
  if (fault.empty()) fault = introduced(before, after);
  if (fault.empty()) fault = ServerReplay(after).run();
  return fault.empty() ? ClientReplay(after).run() : fault;
}

std::string replay_on_client(std::string_view transcript) {
  const std::vector<Line> lines = lines_of(transcript);
  const std::string unknown = unknown_verb(lines);
  return unknown.empty() ? ClientReplay(lines).run() : unknown;
}

}  // namespace aucast::test
