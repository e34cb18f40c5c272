// A hostile client: the input is a script of lines. '>' sends the rest of the line, 't' lets time
// pass (10 ms a letter), 'e' ends the client's side, 'x' breaks the connection,
// 's' stops the server, 'h' holds it back (more letters) or lets it go on; any other line is sent
// as it is.

#include <optional>
#include <vector>

#include "common/check.h"
#include "protocol/limits.h"
#include "protocol/live_replay.h"
#include "protocol/server_session.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/unit/protocol/packets.h"

using namespace aucast;
using namespace aucast::protocol;

namespace {

constexpr std::size_t kLargePacket = 3000;

/// Follows the events and checks what must hold for any peer.
class Watch {
 public:
  void take(const std::vector<ServerEvent>& events) {
    for (const ServerEvent& event : events) {
      AUCAST_CHECK(!closed_);
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        AUCAST_CHECK(!send->bytes.empty());
        AUCAST_CHECK(send->bytes.size() < kOutputBytesMax + 3 * kLargePacket);
      } else {
        const auto* close = std::get_if<CloseConnection>(&event);
        AUCAST_CHECK(close == nullptr || !close->reason.empty());
        closed_ = true;
      }
    }
  }
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  bool closed_ = false;
};

/// A voice with a gap and a tail, and two captions.
std::shared_ptr<const SpokenTrack> spoken_words() {
  auto voice = std::make_shared<EncodedTrack>();
  for (const int place : {0, 60, 200, 400}) voice->add({Milliseconds(place), "\x58\x01"});
  voice->finish();
  return std::make_shared<const SpokenTrack>(SpokenTrack{voice, {{0, "a"}, {260, ""}}});
}

/// A stream of one short packet, "b", and one of packets that soon fill what is sent at once, "c".
void add_plain_streams(ServerCatalogue& catalogue) {
  const std::string large = '{' + std::string(kLargePacket - 2, ' ') + '}';
  catalogue.streams.push_back(
      {"b", RecordedStream{std::make_shared<const EncodedStream>(
                EncodedStream{test::packets({"{0}"}), test::packets({"{0}"}), {}, {}, {}})}});
  catalogue.streams.push_back(
      {"c", RecordedStream{std::make_shared<const EncodedStream>(EncodedStream{
                test::packets({large, large}), test::packets({large, large}), {}, {}, {}})}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Script script(fuzz::text_of(data, size));
  ServerCatalogue catalogue;
  EncodedStream a{test::packets({"{1}", "{2}", "{3}"}),
                  test::packets({"{1:30}", "{2;40}", "{3}"}),
                  {},
                  {},
                  120};
  const auto kind = script.byte();
  catalogue.loop = (kind & 1U) != 0;
  const auto spoken = (kind & 4U) != 0 ? spoken_words() : nullptr;
  Instant now{};
  std::shared_ptr<LiveReplay> live;
  if ((kind & 2U) != 0) {
    a.changes = test::packets({"{1:30}", "{~2;40}", "{3}"});
    a.times = {KeyframeTime(250), KeyframeTime(40), KeyframeTime(0)};
    live = std::make_shared<LiveReplay>(std::make_shared<const EncodedStream>(a), catalogue.loop,
                                        now, spoken);
    catalogue.streams = {{"a", live}};
  } else {
    if (spoken) a.times = {KeyframeTime(250), KeyframeTime(40), KeyframeTime(0)};
    catalogue.streams = {{"a", RecordedStream{std::make_shared<const EncodedStream>(a), spoken}}};
  }
  add_plain_streams(catalogue);
  if ((kind & 8U) != 0) {
    using Publisher = Publishers::Publisher;
    catalogue.publishers = std::make_shared<const Publishers>(
        std::vector<Publisher>{{"word", {}}, {"bound", {"talk"}}});
    catalogue.publish_refused = [](const HelloAsked& hello) -> std::optional<ErrorReply> {
      if (hello.publish != "a") return std::nullopt;
      return ErrorReply{kNameTaken, "it is one of this server's own"};
    };
    catalogue.patience = Milliseconds(100);
  }
  ServerSession session(catalogue, Milliseconds(script.byte()), now);
  Watch watch;
  while (!script.empty()) {
    const std::string_view line = script.line();
    const std::uint64_t sent_before = session.sent().keyframes;
    switch (line.empty() ? '\n' : line.front()) {
      case 't':
        now += Milliseconds(10 * line.size());
        watch.take(session.on_time(now));
        while (live && live->advance(now)) watch.take(session.on_moment(now));
        break;
      case 'h':
        watch.take(session.set_blocked(line.size() > 1, now));
        break;
      case 'e':
        watch.take(session.on_peer_end(now));
        break;
      case 'x':
        watch.take(session.on_lost(now));
        break;
      case 's':
        watch.take(session.stop(now));
        break;
      case '>':
        watch.take(session.on_bytes(line.substr(1), now));
        break;
      default:
        watch.take(session.on_bytes(line, now));
        break;
    }
    AUCAST_CHECK(session.sent().keyframes - sent_before <= kEarlyAnswersMax + kWindowMax);
    if (watch.closed()) AUCAST_CHECK(!session.deadline() && !session.awaiting_answer());
  }
  // Whatever has happened, a lost connection and enough time close it.
  watch.take(session.on_lost(now));
  AUCAST_CHECK(watch.closed());
  return 0;
}
