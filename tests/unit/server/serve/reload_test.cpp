// SIGHUP without a signal or a socket: the test is whoever reads the sources.
#include "server/serve/reload.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <new>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <asio/executor_work_guard.hpp>

#include "tests/support/kept_log.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/protocol/packets.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

Repertoire only(const std::string& name) {
  protocol::EncodedStream stream;
  stream.classic = stream.negotiated = test::packets({"{1}"});
  stream.times.assign(1, protocol::KeyframeTime(100));
  const auto encoded = std::make_shared<const protocol::EncodedStream>(std::move(stream));
  return {{{name, protocol::RecordedStream{encoded}}}};
}

class ReloadTest : public ::testing::Test {
 protected:
  using LoadRepertoire = std::function<Result<Repertoire>(const std::stop_token&)>;
  Reload& make(LoadRepertoire load) {
    return make_with_conditioning(
        [load = std::move(load)](const std::stop_token& stop) -> Result<LoadedSources> {
          auto repertoire = load(stop);
          if (!repertoire) return repertoire.error();
          return LoadedSources{*std::move(repertoire), {}};
        });
  }
  Reload& make_with_conditioning(Reload::Load load) {
    return reload_.emplace(io_, files_, certificates_, programme_, std::move(load),
                           [this](const Reload::Outcome& outcome) {
                             ++times_done_;
                             changed_ = outcome.changed;
                             last_.push_back(outcome.last);
                           });
  }
  /// Until nothing is being read.
  void run() {
    EXPECT_TRUE(test::run_until(io_, [this] { return !reload_->running(); }));
  }
  /// Runs a reload to its end. Whether who comes now gets other streams.
  bool reloaded() {
    changed_ = false;
    reload_->start();
    run();
    return changed_;
  }
  [[nodiscard]] std::string served() const { return programme_.catalogue()->streams[0].name; }

  const test::QuietLog quiet_;
  const test::TempFolder folder_;
  asio::io_context io_;
  const asio::executor_work_guard<asio::io_context::executor_type> work_ =
      asio::make_work_guard(io_);
  TransmitterOptions options_;
  CredentialFiles files_;
  Programme programme_{io_, options_, only("a"), {[] {}, [] {}}};
  int times_done_ = 0;
  std::vector<bool> last_;  ///< of each outcome
  bool changed_ = false;
  Certificates certificates_;
  std::optional<Reload> reload_;
};

TEST_F(ReloadTest, WhatWasReadIsServedFromThenOn) {
  const Reload& reload = make([](const std::stop_token&) { return only("b"); });
  EXPECT_TRUE(reloaded());
  EXPECT_EQ(served(), "b");
  EXPECT_FALSE(reloaded()) << "the same again";
  EXPECT_EQ(reload.successes(), 2U);
  EXPECT_EQ(reload.failures(), 0U);
}

TEST_F(ReloadTest, WhatCannotBeReadChangesNothing) {
  const Reload& reload = make([](const std::stop_token&) -> Result<Repertoire> {
    return Error{ErrorKind::BadData, "b.txt:1:1: broken"};
  });
  EXPECT_FALSE(reloaded());
  EXPECT_EQ(served(), "a");
  EXPECT_EQ(reload.failures(), 1U);
}

TEST_F(ReloadTest, TooLittleMemoryChangesNothing) {
  const Reload& reload =
      make([](const std::stop_token&) -> Result<Repertoire> { throw std::bad_alloc(); });
  EXPECT_FALSE(reloaded());
  EXPECT_EQ(served(), "a");
  EXPECT_EQ(reload.failures(), 1U);
}

TEST_F(ReloadTest, WithoutTheFileOfTheTokenTheSourcesStayToo) {
  files_.token = folder_.write("token", "0123456789abcdef\n");
  Reload& reload = make([](const std::stop_token&) { return only("b"); });
  ASSERT_TRUE(reload.read_credentials());
  std::filesystem::remove(files_.token);
  EXPECT_FALSE(reloaded());
  EXPECT_EQ(programme_.catalogue()->token, "0123456789abcdef");
  EXPECT_EQ(served(), "a") << "who has the old token would see what it is not for";
  EXPECT_EQ(reload.failures(), 1U);
  EXPECT_EQ(reload.successes(), 0U);
}

TEST_F(ReloadTest, WithBrokenSourcesTheTokenStaysToo) {
  files_.token = folder_.write("token", "0123456789abcdef\n");
  Reload& reload = make([](const std::stop_token&) -> Result<Repertoire> {
    return Error{ErrorKind::BadData, "b.txt:1:1: broken"};
  });
  ASSERT_TRUE(reload.read_credentials());
  folder_.write("token", "fedcba9876543210\n");
  EXPECT_FALSE(reloaded());
  EXPECT_EQ(programme_.catalogue()->token, "0123456789abcdef");
}

TEST_F(ReloadTest, TokenAndSourcesAreTakenOverTogether) {
  files_.token = folder_.write("token", "0123456789abcdef\n");
  make([](const std::stop_token&) { return only("b"); });
  EXPECT_TRUE(reloaded());
  EXPECT_EQ(programme_.catalogue()->token, "0123456789abcdef");
  EXPECT_EQ(served(), "b");
}

/// The profile is gone when all is taken over: it is not read a second time.
TEST_F(ReloadTest, TheProfileIsTakenOverAsItWasRead) {
  using sources::tables::openface2_row;
  const auto face = folder_.write(
      "face.csv", sources::tables::kOpenFace2Header + openface2_row(1, "0.00", "0,1,0,0,0,0,0"));
  options_.sources = {face};
  options_.live_source.follow = true;
  options_.source.signal.profile = folder_.write("me.toml", "[gain]\n12 = 1\n");
  ASSERT_TRUE(programme_.open_sources());
  programme_.begin();
  const auto sends = [this](const char* packet) {
    return test::run_until(io_, [&] {
      const auto* const moment = programme_.named_or_first("face")->live()->newest();
      return moment != nullptr && moment->full == packet;
    });
  };
  EXPECT_TRUE(sends("{12:20;40}"));
  const test::KeptLog log;
  make_with_conditioning([this](const std::stop_token& stop) {
    auto loaded = load_repertoire(options_, stop);
    std::filesystem::remove(options_.source.signal.profile);
    return loaded;
  });
  folder_.write("me.toml", "[gain]\n12 = 2\n");
  reloaded();
  EXPECT_EQ(reload_->successes(), 1U);
  EXPECT_NE(log.said().find("the profile was read again"), std::string::npos) << log.said();
  std::ofstream(face, std::ios::app) << openface2_row(2, "0.04", "0,1,0,0,0,0,0") << std::flush;
  EXPECT_TRUE(sends("{12:40;40}"));
}

TEST_F(ReloadTest, AskedAgainMeanwhileItReadsOnceMore) {
  Reload& reload = make([](const std::stop_token&) { return only("b"); });
  for (int n = 0; n < 5; ++n) reload.start();
  run();
  EXPECT_EQ(times_done_, 2);
  EXPECT_EQ(last_, (std::vector<bool>{false, true})) << "who asked last has not been served before";
  EXPECT_EQ(reload.successes(), 2U);
}

TEST_F(ReloadTest, EachOfTwoOrdersReadsTheTokenAsItIsThen) {
  files_.token = folder_.write("token", "0123456789abcdef\n");
  Reload& reload = make([this](const std::stop_token&) {
    std::filesystem::remove(files_.token);
    return only("b");
  });
  reload.start();
  reload.start();
  run();
  EXPECT_EQ(reload.successes(), 1U);
  EXPECT_EQ(reload.failures(), 1U);
}

TEST_F(ReloadTest, WhatIsReadAfterTheEndIsNotTakenOver) {
  Reload& reload = make([](const std::stop_token&) { return only("b"); });
  reload.start();
  programme_.stop();
  run();
  EXPECT_EQ(served(), "a");
  EXPECT_EQ(times_done_, 0);
}

/// Else the test would never end.
TEST_F(ReloadTest, WhatIsBeingReadAtTheEndIsGivenUp) {
  std::promise<void> reading;
  std::future<void> begun = reading.get_future();
  make([&reading](const std::stop_token& stop) -> Result<Repertoire> {
    std::promise<void> asked;
    const std::stop_callback on_stop(stop, [&asked] { asked.set_value(); });
    reading.set_value();
    asked.get_future().wait();
    return Error{ErrorKind::Failed, "given up"};
  }).start();
  begun.wait();
  reload_.reset();
  io_.poll();
  EXPECT_EQ(times_done_, 0);
}

TEST_F(ReloadTest, WhatWasReadOnlyAtItsEndReachesNobody) {
  make([](const std::stop_token&) { return only("b"); }).start();
  reload_.reset();
  EXPECT_GT(io_.poll(), 0U) << "it had been posted";
  EXPECT_EQ(times_done_, 0);
  EXPECT_EQ(served(), "a");
}

}  // namespace
}  // namespace aucast::server
