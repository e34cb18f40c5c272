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

/// Shows the face that the user's camera sees, before anybody else can see that face. It runs
/// au-transmitter as a child process.
/// Thread: it has one of its own; its public functions are called from one other thread.
class Mirror final : public OwnCamera {
 public:
  /// Fails with Unreadable if au-transmitter is not installed, or with ErrorKind::Failed if it
  /// cannot be started.
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
    bool reading = true;  ///< the child's output has not ended, so the child may still be given
                          ///< orders, or be killed
  };

  std::unique_ptr<Child> child_;
  Shared<Course> course_;
  // Last, so that it is joined before what it uses is destroyed.
  std::jthread thread_;
};

}  // namespace aucast::mirror
