#pragma once

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/app/window/window_model.h"
#include "client/app/window/window_session.h"
#include "client/playback/source_playback.h"
#include "tests/support/manual_clock.h"
#include "tests/unit/playback/scripted_source.h"

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
    return session_->face().activations(clock_.now())[*assets_->face.channel_index(channel)];
  }
  [[nodiscard]] gui::GuiModel model() const { return model_of(*session_); }
  [[nodiscard]] Result<std::filesystem::path> new_picture() const {
    return new_picture_file(session_->settings().pictures(), session_->named(), "2026-11-30",
                            ".png");
  }

  inline static std::unique_ptr<Assets> assets_;
  PlayerOptions options_;
  PlayerStats stats_;
  test::ManualClock clock_;
  std::optional<WindowSession> session_;
};

inline AuFrame frame(std::initializer_list<AuTerm> terms) {
  return frame_from_terms({terms.begin(), terms.size()});
}

/// The default face, driven by a source that the test fills by hand.
class PlayedSession : public SessionOnDefaultFace {
 protected:
  void SetUp() override { options_.playback.endpoint = "127.0.0.1:4650"; }

  /// Opens a source that has these keyframes of 100 ms.
  void open(const std::vector<AuFrame>& keyframes) {
    auto source = std::make_unique<playback::test::ScriptedSource>();
    source_ = source.get();
    source_->now.connected = true;
    for (const AuFrame& aus : keyframes) source_->keyframes.push_back({aus, Milliseconds(100)});
    const playback::SourcePlayback::Options how{options_.playback.speed, options_.playback.hold};
    auto playback = std::make_unique<playback::SourcePlayback>(std::move(source), how);
    playback_ = playback.get();
    session_.emplace(*assets_, options_, std::move(playback), stats_);
  }
  void open_nothing() { session_.emplace(*assets_, options_, nullptr, stats_); }

  void ask(const gui::GuiCommand& command) { session_->apply(command, clock_.now()); }
  [[nodiscard]] static int channel(const char* name) {
    return static_cast<int>(*assets_->face.channel_index(name));
  }
  [[nodiscard]] static std::size_t expression(const char* name) {
    const auto& all = assets_->expressions;
    const auto found =
        std::find_if(all.begin(), all.end(), [name](const auto& one) { return one.name == name; });
    return static_cast<std::size_t>(found - all.begin());
  }

  playback::test::ScriptedSource* source_ = nullptr;
  playback::Playback* playback_ = nullptr;  ///< of source_
};

}  // namespace aucast::app
