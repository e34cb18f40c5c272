// A hostile server: the input is a script of lines. '>' (or any other beginning) is what the server
// sends; 't' lets time pass, 'e' closes, 'a' answers, 'p' pauses, 'r' resumes, 'q' stops.

#include "common/check.h"
#include "protocol/client_session.h"
#include "protocol/decoder.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;
using namespace aucast::protocol;

namespace {

/// Follows the session and checks what must hold for any server.
class Watch {
 public:
  void take(const std::vector<ClientEvent>& events) {
    for (const ClientEvent& event : events) {
      AUCAST_CHECK(!over_);
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        say(send->bytes);
      } else if (const auto* failed = std::get_if<SessionFailed>(&event)) {
        AUCAST_CHECK(!failed->reason.empty());
        over_ = true;
      } else {
        over_ = std::holds_alternative<StreamEnded>(event) ||
                std::holds_alternative<ReconnectClassic>(event);
      }
    }
  }
  /// Everything that a client says must be legal for a server.
  void say(std::string_view bytes) {
    while (said_.next(bytes)) {
    }
    AUCAST_CHECK(!said_.error());
  }
  [[nodiscard]] bool over() const { return over_; }

 private:
  ClientPacketDecoder said_;
  bool over_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Script script(fuzz::text_of(data, size));
  ClientSessionOptions options;
  const std::uint8_t flags = script.byte();
  options.negotiate = (flags & 1U) != 0;
  options.hello.delta = (flags & 2U) != 0;
  options.hello.window = (flags >> 2U) & 7U;
  if ((flags & 32U) != 0) options.hello.voice = kVoiceCodec;
  options.hello.text = (flags & 64U) != 0;
  Instant now{};
  ClientSession session(options);
  Watch watch;
  watch.take(session.on_connected(now));
  while (!script.empty()) {
    std::string_view line = script.line();
    switch (line.empty() ? '\n' : line.front()) {
      case 't':
        now += Milliseconds(500 * line.size());
        watch.take(session.on_time(now));
        break;
      case 'e':
        watch.take(session.on_closed());
        break;
      case 'a':
        watch.say(session.answer_received());
        break;
      case 'p':
        watch.say(session.pause());
        break;
      case 'r':
        watch.say(session.resume());
        break;
      case 'q':
        watch.say(session.stop());
        break;
      case '>':
        line.remove_prefix(1);
        [[fallthrough]];
      default:
        while (!line.empty()) watch.take(session.on_bytes(line));
        break;
    }
    if (watch.over()) AUCAST_CHECK(!session.deadline());
  }
  watch.take(session.on_closed());
  AUCAST_CHECK(watch.over());
  return 0;
}
