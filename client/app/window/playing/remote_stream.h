#pragma once

#include <cstdint>
#include <memory>

#include "client/app/window/playing/playback_history.h"
#include "client/app/window/playing/playing_stream.h"
#include "client/playback/keyframe_buffers.h"

namespace aucast::app {

/// A server's stream. What was received is kept, because it cannot be requested again.
class RemoteStream final : public PlayingStream {
 public:
  enum class Server : std::uint8_t {
    Chosen,     ///< the user chose the server; it is remembered when it answers
    OwnCamera,  ///< the server is the player's own child process: it is never remembered, and only
                ///< the user ends it
  };
  /// `buffers`: those of the source.
  RemoteStream(std::unique_ptr<playback::Playback> playback, const playback::BufferOptions& buffers,
               Server server);

  [[nodiscard]] playback::Playback& playback() override { return *playback_; }
  [[nodiscard]] const playback::Playback& playback() const override { return *playback_; }
  [[nodiscard]] std::unique_ptr<playback::Playback> hand_out() override {
    return std::move(playback_);
  }
  void begun(const playback::KeyframeBegun& keyframe) override;
  void advanced(Instant now, const AuFrame& aus) override;
  [[nodiscard]] bool take_answer() override;
  [[nodiscard]] LiveObjection objection(const PlaybackOptions& options) const override {
    return live_objection(options, playback_->status());
  }
  void stop(Instant now) override { playback_->stop(now); }
  bool resume(Instant now) override;
  [[nodiscard]] bool stands() const override;
  [[nodiscard]] Duration idle_time() const override;
  [[nodiscard]] std::string title(const std::string& program, bool over) const override;
  /// The keyframes that have begun so far, at most Played::kKept.
  [[nodiscard]] Played played() const override { return received_; }
  [[nodiscard]] bool of_chosen_server() const override { return server_ == Server::Chosen; }
  [[nodiscard]] bool ended_by_server() const override;
  void describe(gui::PlayingView& view) const override;

 private:
  void describe_trouble(const playback::SourceStatus& status, gui::PlayingView& view) const;
  void describe_traffic(const playback::SourceStatus& status, gui::PlayingView& view) const;

  std::unique_ptr<playback::Playback> playback_;
  playback::BufferOptions buffers_;
  Server server_;
  Played received_;
  PlaybackHistory history_;
  std::uint64_t tried_ = 0;  ///< number of attempts after a loss, as of the last frame
  Instant again_at_{};       ///< when the attempt under way began, or the next one begins
  Instant now_{};            ///< the time of the last frame
  bool remembered_ = false;
  bool timed_ = false;  ///< the keyframe under way has a time of its own
};

}  // namespace aucast::app
