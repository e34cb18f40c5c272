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

/// A camera whose face is shown here before anybody else sees it: au-transmitter as a child.
/// Thread: one of its own; everything here from one thread.
class Mirror final : public OwnCamera {
 public:
  /// Unreadable when au-transmitter is not there, Failed when it cannot be started.
  [[nodiscard]] static Result<std::unique_ptr<Mirror>> start(const MirrorOptions& options);
  /// end(), and at most kPatience later it is killed.
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
    bool reading = true;  ///< the child may be given orders, and be killed
  };

  std::unique_ptr<Child> child_;
  Shared<Course> course_;
  // Comes last: it uses all of the above.
  std::jthread thread_;
};

}  // namespace aucast::mirror
