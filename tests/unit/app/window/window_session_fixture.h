#pragma once

#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "client/app/window/window_session.h"
#include "tests/support/manual_clock.h"

namespace aucast::app {

/// A session on the default face, which is loaded once for all tests of a suite.
class SessionOnDefaultFace : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto loaded = load_assets({});
    ASSERT_TRUE(loaded) << loaded.error().message;
    assets_ = std::move(*loaded);
  }
  static void TearDownTestSuite() { assets_.reset(); }

  void go_on(Milliseconds time) {
    clock_.advance(time);
    session_->advance(clock_.now());
  }
  [[nodiscard]] float shown(const char* channel) {
    return session_->activations(clock_.now())[*assets_->face.channel_index(channel)];
  }
  [[nodiscard]] gui::GuiModel model() const { return session_->model(); }

  inline static std::unique_ptr<Assets> assets_;
  PlayerOptions options_;
  PlayerStats stats_;
  test::ManualClock clock_;
  std::optional<WindowSession> session_;
};

}  // namespace aucast::app
