#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/action_unit.h"
#include "common/result.h"
#include "common/sources/live_queue.h"
#include "common/sources/live_reader.h"
#include "common/time.h"
#include "common/voice/voice_encoder.h"
#include "protocol/codec.h"
#include "protocol/live_feed.h"
#include "protocol/server_session.h"
#include "server/live/recorder.h"
#include "server/live/source_silence.h"
#include "server/streams/live_thinning.h"
#include "server/voice/live_voice.h"

namespace aucast::server {

/// How a source that is still being written is served.
struct LiveStreamOptions {
  std::filesystem::path path;  ///< of the source; "-" is stdin
  sources::LiveOptions reader;
  int classic_min = 20;
  /// The silence after which clients get {-2}; 0: never.
  Milliseconds timeout{10'000};
  LinkLimits link;     ///< how many bits a second each client's face and voice may take
  bool voice = false;  ///< raw sound arrives, too, for the first of this source's streams
  voice::VoiceSettings encoder{};
  Milliseconds voice_delay{0};
};

/// One stream of a source that is being written.
///
///   bytes --reader--> queue --when due: pass()--> record, if there is one
///                                             +-> thinning --when there is room: show()--> feed
///   sound --LiveVoice: send_voice()--> record, feed
///
/// When nothing comes (rest()), the face holds, then goes to neutral, and after the time-out the
/// stream ends for its clients; it goes on when something comes. With a voice, the stream's clock
/// keeps running meanwhile: the held face is sent with the time for which it was held
/// (fill_pause()).
///
/// Thread: none of its own.
class LiveStream {
 public:
  /// `options` outlives it. `reading` replaces `options.reader`. `on_moment` is called when the
  /// stream has something new.
  LiveStream(std::string name, const LiveStreamOptions& options,
             const sources::LiveOptions& reading, bool with_voice, std::function<void()> on_moment);
  LiveStream(const LiveStream&) = delete;
  LiveStream& operator=(const LiveStream&) = delete;

  /// Records the stream in this file from now on. Fails as Recorder::start() does.
  [[nodiscard]] Result<void> record(const std::filesystem::path& path);
  /// Waits until the record is written. Fails with what ended it early, if anything did.
  [[nodiscard]] Result<void> finish_record();

  /// The reader, to be fed with the source's bytes; its keyframes wait in it until take().
  [[nodiscard]] sources::LiveReader& reader() { return reader_; }
  /// Takes the keyframes that the reader has made; with `only_last` only the newest, since the
  /// others are out of date.
  void take(SteadyTime now, bool only_last);
  void feed_voice(std::string_view bytes, SteadyTime now);
  void end_voice(SteadyTime now);
  /// The writer has gone. `for_good`: nobody can write any more.
  void end_input(SteadyTime now, bool for_good);
  /// Sends what is due; when the source has been silent, lets the face go to neutral or ends the
  /// stream.
  void go_on(SteadyTime now);
  /// When to call go_on() next; nullopt: not before something is fed.
  [[nodiscard]] std::optional<SteadyTime> next() const;
  /// Whether the queue is full: then feed nothing for now.
  [[nodiscard]] bool full() const;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] protocol::ServedStream served() const { return {name_, feed_}; }
  [[nodiscard]] bool begun() const { return feed_->newest() != nullptr; }
  /// Whether all clients were told that the stream has ended, and nothing is queued.
  [[nodiscard]] bool ended() const { return feed_->ended() && queue_.size() == 0; }

 private:
  void send_voice(std::vector<protocol::VoicePacket> packets, SteadyTime now);
  void send_due(SteadyTime now);
  // `free`: see sources::RecordTimeline::add().
  void send(const sources::LiveKeyframe& keyframe, bool free, SteadyTime now);
  void fill_pause(SteadyTime now);
  void pass(const protocol::Keyframe& keyframe, bool free, SteadyTime now);
  void send_thinned(SteadyTime now);
  void show(const protocol::Keyframe& keyframe);
  void rest(SteadyTime now);
  void ease(SteadyTime now);
  void end_by_silence();
  void end();
  [[nodiscard]] std::optional<SteadyTime> silent_since() const;
  [[nodiscard]] SteadyTime beat() const;

  std::string name_;
  const LiveStreamOptions& options_;
  std::function<void()> on_moment_;
  std::shared_ptr<protocol::LiveFeed> feed_;  ///< its sessions hold it too
  sources::LiveReader reader_;
  sources::LiveQueue queue_;
  LiveThinning thinning_;
  std::unique_ptr<Recorder> recorder_;
  SourceSilence silence_;
  Milliseconds end_{0};  ///< of the last keyframe that was made, on the feed's clock

  // With a voice only.
  std::optional<LiveVoice> voice_;
  std::optional<SteadyTime> clock_begin_;  ///< of the feed's clock; nullopt: it is stopped
  SteadyTime voice_at_;                    ///< when voice last came
  std::vector<AuTerm> shown_;
};

}  // namespace aucast::server
