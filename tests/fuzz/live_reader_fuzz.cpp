// A live source that sends anything: the input is a script of lines. '>' (or any other beginning)
// is a line that comes, '-' one whose end has not come yet; 't' lets time pass, 'e' is the writer's
// end, 'n' a file that begins anew. The first line has the options: 'f' --fps, '1' --face-id 1, 'r'
// --rate.

#include "common/check.h"
#include "common/sources/live_queue.h"
#include "common/sources/live_reader.h"
#include "common/sources/record_timeline.h"
#include "protocol/codec.h"
#include "protocol/limits.h"
#include "protocol/stream_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;
using namespace aucast::sources;

namespace {

LiveOptions options_of(std::string_view line) {
  LiveOptions options;
  if (line.find('f') != std::string_view::npos) options.recording.fps = 30;
  if (line.find('1') != std::string_view::npos) options.recording.face = 1;
  if (line.find('r') != std::string_view::npos) options.rate = 10;
  return options;
}

Result<ArkitTable> curves() {
  return ArkitTable{{{"jawOpen", 26, Side::Both, 1}, {"eyeBlinkLeft", 45, Side::Left, 1}}};
}

/// What LiveSource does with a reader, and what must hold of everything that it serves.
class Source {
 public:
  explicit Source(LiveOptions options) : reader_("f", std::move(options), curves) {}

  void feed(std::string_view bytes) { reader_.feed(bytes, now_); }
  void end_input() { reader_.end_input(now_); }
  void restart() { reader_.restart(); }

  void go_on() {
    for (LiveKeyframe& keyframe : reader_.take_keyframes()) queue_.push(std::move(keyframe), now_);
    bool sent = false;
    while (const auto keyframe = queue_.pop(now_)) {
      serve(keyframe->keyframe, keyframe->begins || !keyframe->clocked);
      sent = true;
    }
    if (sent) reader_.hold_off(now_);
    if (queue_.size() == 0) {
      reader_.idle(now_);
      for (const LiveKeyframe& keyframe : reader_.take_keyframes()) serve(keyframe.keyframe, true);
      AUCAST_CHECK(!reader_.idle_due() ||
                   *reader_.idle_due() > now_ - std::chrono::milliseconds(1));
    }
    for (const LiveMessage& message : reader_.take_messages()) {
      AUCAST_CHECK(message.text.starts_with("f:"));
    }
  }

  void pass(double seconds) {
    now_ += Seconds(seconds);
    go_on();
  }

 private:
  /// Whatever is served can be a line of a stream file, and says the same there.
  void serve(const protocol::Keyframe& keyframe, bool free) {
    for (const protocol::Keyframe& line : record_.add(keyframe, now_, free)) {
      const std::int64_t time_ms = line.time_ms.value_or(0);
      AUCAST_CHECK(time_ms >= 1 && time_ms <= protocol::kKeyframeTimeMsMax);
      protocol::Keyframe again;
      const std::string text = protocol::format_stream_line(line);
      AUCAST_CHECK(!protocol::parse_stream_line(text, again));
      AUCAST_CHECK(protocol::format_stream_line(again) == text);
    }
  }

  LiveReader reader_;
  LiveQueue queue_;
  RecordTimeline record_;
  SteadyTime now_{Seconds(1000)};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Script script(fuzz::text_of(data, size));
  Source source(options_of(script.line()));
  while (!script.empty()) {
    const std::string_view line = script.line();
    switch (line.empty() ? '\n' : line.front()) {
      case 't':
        source.pass(0.05 * static_cast<double>(line.size() * line.size()));
        break;
      case 'e':
        source.end_input();
        break;
      case 'n':
        source.restart();
        break;
      case '-':
        source.feed(line.substr(1));
        break;
      case '>':
        source.feed(line.substr(1));
        source.feed("\n");
        break;
      default:
        source.feed(line);
        source.feed("\n");
        break;
    }
    source.go_on();
  }
  source.end_input();
  for (int step = 0; step < 20; ++step) source.pass(0.1);
  return 0;
}
