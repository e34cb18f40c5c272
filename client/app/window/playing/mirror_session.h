#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "client/gui/mirror_view.h"
#include "client/mirror/mirror_options.h"
#include "client/mirror/own_camera.h"
#include "common/result.h"
#include "protocol/endpoint.h"

namespace aucast::app {

/// The camera of the window, and what the panels show of it. Thread: the player's.
class MirrorSession {
 public:
  /// Opens a camera; Unreadable when au-transmitter is not there.
  using Start = std::function<Result<std::unique_ptr<mirror::OwnCamera>>(
      const mirror::MirrorOptions& options)>;
  /// `options`: what the window begins with; it opens no camera yet.
  explicit MirrorSession(mirror::MirrorOptions options, Start start = start_mirror);

  void apply(const gui::MirrorCommand& command);
  /// What Start opens next time.
  void set_source(std::string source) { view_.source = std::move(source); }
  /// Takes over what came. Where its stream can be played, once when that is known.
  [[nodiscard]] std::optional<protocol::Endpoint> advance();
  [[nodiscard]] const gui::MirrorView& view() const { return view_; }
  [[nodiscard]] bool running() const { return mirror_ != nullptr; }

 private:
  [[nodiscard]] static Result<std::unique_ptr<mirror::OwnCamera>> start_mirror(
      const mirror::MirrorOptions& options);
  /// Before anything was seen.
  [[nodiscard]] gui::MirrorView view_of_options() const;
  void start(const std::string& source);
  /// The camera is off; what the trouble was stays to be read.
  void finish();
  [[nodiscard]] gui::MirrorView::Phase phase(const mirror::MirrorState& state) const;

  mirror::MirrorOptions options_;
  Start start_;
  std::unique_ptr<mirror::OwnCamera> mirror_;
  gui::MirrorView view_;
  bool played_ = false;  ///< advance() has said where
  bool ending_ = false;
};

}  // namespace aucast::app
