#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "client/mirror/mirror_options.h"
#include "client/mirror/own_camera.h"
#include "common/child.h"
#include "common/preview/preview_reader.h"
#include "common/result.h"
#include "common/shared.h"

namespace aucast::mirror {

/// Shows the face that a camera sees before anybody else can see it. It runs au-transmitter as a
/// child process.
/// Thread: one of its own; the functions here are called from one other thread.
class Mirror final : public OwnCamera {
 public:
  /// Unreadable if au-transmitter is not installed, Failed if it cannot be started.
  [[nodiscard]] static Result<std::unique_ptr<Mirror>> start(const MirrorOptions& options);
  /// Calls end(), and kills the child if it has not ended within kPatience.
  ~Mirror() override;

  static constexpr std::chrono::milliseconds kPatience{2'500};

  void order(const preview::Order& order) override;
  void end() override;
  [[nodiscard]] MirrorState state() const override;

 private:
  explicit Mirror(std::unique_ptr<Child> child);
  void read();
  void take(preview::Record record);
  [[nodiscard]] std::optional<std::string> take_all(preview::PreviewReader& reader);

  struct Course {
    MirrorState state;
    bool asked_to_end = false;
    bool reading = true;  ///< the child's output has not ended: it may still be given orders, or
                          ///< killed
  };

  std::unique_ptr<Child> child_;
  Shared<Course> course_;
  // Last, so that it is joined before what it uses is destroyed.
  std::jthread thread_;
};

}  // namespace aucast::mirror
