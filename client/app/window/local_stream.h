#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/gui/gui_model.h"
#include "client/gui/stream_view.h"
#include "client/pipeline/face_pipeline.h"
#include "client/playback/keyframe_source.h"
#include "client/playback/local_playback.h"
#include "common/result.h"

namespace aucast::app {

/// The keyframes of a stream file. Unreadable, or BadData with a line for each error.
[[nodiscard]] Result<std::vector<playback::TimedAus>> read_stream(
    const std::filesystem::path& file);

/// A stream that is there whole, and where playing it stands. Time is handed in.
/// Thread: the player's.
class LocalStream {
 public:
  /// `keyframes`: at least one; those without a time of their own take `untimed`. It plays from the
  /// first advance() on.
  LocalStream(std::string name, std::vector<playback::TimedAus> keyframes, Milliseconds untimed);

  void apply(const gui::LocalCommand& command, Instant now);
  void play(Instant now);
  void pause(Instant now);
  void rewind(Instant now);
  /// Moves to `now`; true when another keyframe than before is under way.
  bool advance(Instant now);
  /// Brings `pipeline` to the keyframe under way, whatever it showed before.
  void begin(pipeline::FacePipeline& pipeline) const;

  // All of the moment of the last advance().
  [[nodiscard]] double mu() const { return place_.mu; }
  [[nodiscard]] bool moving() const { return playback_.playing() && !over_; }
  [[nodiscard]] bool over() const { return over_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] gui::LocalView view() const;
  /// The same as the remote player's panel has it.
  void describe(gui::RemoteView& view) const;

  [[nodiscard]] const playback::LocalPlayback& playback() const { return playback_; }
  [[nodiscard]] const std::vector<playback::TimedAus>& keyframes() const { return keyframes_; }

 private:
  std::string name_;
  std::vector<playback::TimedAus> keyframes_;
  playback::LocalPlayback playback_;
  std::shared_ptr<const std::vector<Duration>> ends_;
  playback::StreamPlace place_;
  Duration position_{0};
  bool fresh_ = true;  ///< nobody has played, paused or sought it
  bool begun_ = false;
  bool over_ = false;
};

}  // namespace aucast::app
