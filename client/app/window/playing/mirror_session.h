#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "client/gui/model/mirror_view.h"
#include "client/mirror/mirror_options.h"
#include "client/mirror/own_camera.h"
#include "common/result.h"
#include "protocol/endpoint.h"

namespace aucast::app {

/// The window's camera, and what the panels show of it. Thread: the player's.
class MirrorSession {
 public:
  /// Opens a camera. Fails with Unreadable if au-transmitter is not installed.
  using Start = std::function<Result<std::unique_ptr<mirror::OwnCamera>>(
      const mirror::MirrorOptions& options)>;
  /// `options`: what the window begins with. No camera is opened yet.
  explicit MirrorSession(mirror::MirrorOptions options, Start start = start_mirror);

  void apply(const gui::MirrorCommand& command);
  /// Sets the camera or film that the button Start opens next time.
  void set_source(std::string source) { view_.source = std::move(source); }
  /// Where the camera's stream can be played.
  struct OwnServer {
    protocol::Endpoint endpoint;
    std::string token;  ///< to be shown there; empty: none
    friend bool operator==(const OwnServer&, const OwnServer&) = default;
  };
  /// Updates view() with what the camera reports. Returns, once, where its stream can be played,
  /// when that is known.
  [[nodiscard]] std::optional<OwnServer> advance();
  [[nodiscard]] const gui::MirrorView& view() const { return view_; }
  [[nodiscard]] bool running() const { return mirror_ != nullptr; }

 private:
  [[nodiscard]] static Result<std::unique_ptr<mirror::OwnCamera>> start_mirror(
      const mirror::MirrorOptions& options);
  /// The view before any picture has come.
  [[nodiscard]] gui::MirrorView view_of_options() const;
  void start(const std::string& source);
  /// Turns the camera off; the sentence about what went wrong stays.
  void finish();
  [[nodiscard]] gui::MirrorView::Phase phase(const mirror::MirrorState& state) const;

  mirror::MirrorOptions options_;
  Start start_;
  std::unique_ptr<mirror::OwnCamera> mirror_;
  gui::MirrorView view_;
  bool played_ = false;  ///< advance() has returned the server
  bool ending_ = false;
};

}  // namespace aucast::app
