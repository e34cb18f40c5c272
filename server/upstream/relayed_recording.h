#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/result.h"
#include "common/time.h"
#include "protocol/codec.h"
#include "protocol/encoded_stream.h"
#include "protocol/encoded_track.h"
#include "protocol/packet.h"
#include "protocol/upstream_stream.h"
#include "protocol/voice_packet.h"

namespace aucast::server {

/// A recorded stream that comes from parents, one after the other, is kept, and is served while it
/// grows. Each parent is asked to begin at place_ms(), and may repeat what belongs there, which is
/// left out:
///   the keyframes of 0 ms at that place, as many as are here;
///   the voice packet that is heard there;
///   the caption that is shown there, and those that came before the next keyframe.
/// Thread: none of its own.
class RelayedRecording {
 public:
  /// Called with how many bytes it takes; fails if that is too much.
  using MayHold = std::function<Result<void>(std::uint64_t bytes)>;

  /// `hello`: of the first parent; it has a duration.
  RelayedRecording(const protocol::HelloGranted& hello, MayHold may_hold);

  /// Another parent sends it from now on.
  void go_on();

  // What comes from the parent. Each returns what is wrong with it, or nullopt; see RelayedStream.

  [[nodiscard]] std::optional<std::string> add(const protocol::EncodedKeyframe& keyframe,
                                               std::uint32_t time_ms);
  [[nodiscard]] std::optional<std::string> add(const protocol::VoicePacket& voice);
  [[nodiscard]] std::optional<std::string> add(const protocol::CaptionData& caption);
  /// {-2} has come.
  [[nodiscard]] std::optional<std::string> end();

  /// No more comes for now.
  void break_off();

  /// The stream as sessions use it. They see by its lists which forms there are, so it is not
  /// theirs before the first keyframe.
  [[nodiscard]] protocol::RecordedStream content() const { return {encoded_, spoken_}; }
  [[nodiscard]] std::uint64_t duration_ms() const { return encoded_->duration_ms.value_or(0); }
  /// How much of it is here.
  [[nodiscard]] std::uint64_t place_ms() const { return place_ms_; }
  /// Whether it is here to its end, so that nothing is missing.
  [[nodiscard]] bool whole() const { return encoded_->extent == protocol::Extent::Whole; }

 private:
  [[nodiscard]] std::optional<std::string> no_room();

  MayHold may_hold_;
  bool changes_;  ///< the changes-only form is kept too
  std::shared_ptr<protocol::EncodedStream> encoded_ = std::make_shared<protocol::EncodedStream>();
  std::shared_ptr<protocol::SpokenTrack> spoken_;  ///< null: neither voice nor captions
  std::shared_ptr<protocol::EncodedTrack> voice_;  ///< that of spoken_; null: captions only
  std::uint64_t place_ms_ = 0;
  std::size_t caption_bytes_ = 0;    ///< of the captions in spoken_
  std::uint64_t looks_ = 0;          ///< how often it looked whether there is room for more
  std::size_t keyframes_again_ = 0;  ///< how many of 0 ms may still be repeated
  std::size_t caption_again_ = 0;    ///< the index of the next caption that may be repeated
};

}  // namespace aucast::server
