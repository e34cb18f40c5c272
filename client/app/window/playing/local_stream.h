#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/app/notices.h"
#include "client/app/window/playing/playing_stream.h"
#include "client/gui/model/au_curves.h"
#include "client/playback/seekable_playback.h"

namespace aucast::app {

/// A stream that is available whole, such as a file. It can be sought, and played again after its
/// end.
class LocalStream final : public PlayingStream {
 public:
  /// `step_fps`: a step by a picture is 1 / step_fps s. Nullopt: it is a row of the recording or,
  /// if its rows come at no steady rate, a picture of the videos that the window writes. `notices`
  /// must outlive this object.
  LocalStream(std::unique_ptr<playback::SeekablePlayback> playback, std::string name,
              std::optional<int> step_fps, Notices& notices);

  [[nodiscard]] playback::SeekablePlayback& playback() override { return *playback_; }
  [[nodiscard]] const playback::SeekablePlayback& playback() const override { return *playback_; }
  [[nodiscard]] std::unique_ptr<playback::Playback> hand_out() override {
    return std::move(playback_);
  }
  /// Goes to the beginning and pauses there, so that the stream can be played again.
  void stop(Instant now) override;
  bool resume(Instant now) override;
  bool apply(const gui::LocalCommand& command, Instant now) override;
  [[nodiscard]] bool stands() const override;
  [[nodiscard]] std::string title(const std::string& program, bool /*over*/) const override {
    return name_ + " - " + program;
  }
  /// All keyframes of the stream.
  [[nodiscard]] Played played() const override;
  void describe(gui::PlayingView& view) const override;
  [[nodiscard]] gui::LocalView local_view() const override;

 private:
  void step(playback::LocalPlayback& playhead, int direction, Instant now) const;
  [[nodiscard]] int step_fps() const;
  void toggle_repeat(playback::LocalPlayback& playhead, Instant now);

  std::unique_ptr<playback::SeekablePlayback> playback_;
  std::string name_;
  std::optional<int> step_fps_;
  Notices& notices_;
  std::shared_ptr<const gui::AuCurves> curves_;
};

}  // namespace aucast::app
