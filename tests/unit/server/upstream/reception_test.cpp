// A stream that comes over one connection after the other; the test is who sends it.
#include "server/upstream/reception.h"

#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>
#include <asio/post.hpp>

#include "tests/support/fake_link.h"
#include "tests/support/kept_log.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"

namespace aucast::server {
namespace {

constexpr const char* kLost = "reset by peer";

class ReceptionTest : public ::testing::Test {
 protected:
  ReceptionTest() { reception_.start(); }

  /// The next sender comes and says this.
  void connect(const std::string& says) {
    link_ = std::make_shared<test::FakeLink>();
    reception_.begin(link_, "parent", "");
    link_->say(says);
  }
  void lose() { link_->end({link::Ending::Why::Lost, kLost}); }
  [[nodiscard]] bool gives_up() {
    return test::run_until(io_, [this] { return reception_.given_up(); });
  }
  [[nodiscard]] protocol::Extent extent() const {
    return reception_.shared()->recorded()->encoded->extent;
  }
  static Reception::Options options() {
    Reception::Options options;
    options.name = "talk";
    options.wait = Milliseconds(1);
    return options;
  }

  const test::QuietLog quiet_;
  asio::io_context io_;
  std::shared_ptr<test::FakeLink> link_;
  int moments_ = 0;
  Reception reception_{
      io_, options(), {[this] { ++moments_; }, [] {}, [](const Parent::Outcome&) {}}};
};

constexpr const char* kFrom0 = "{hello v=2 window=256 stream=talk duration=120 keyframe=40}";
constexpr const char* kFrom40 =
    "{hello v=2 window=256 stream=talk duration=120 keyframe=40 from=40}";

TEST_F(ReceptionTest, AWaitThatIsOverDoesNotEndTheNext) {
  Reception::Options patient = options();
  patient.wait = Milliseconds(50);
  asio::io_context io;
  Reception reception(io, patient, {[] {}, [] {}, [](const Parent::Outcome&) {}});
  reception.start();
  std::this_thread::sleep_for(patient.wait + Milliseconds(1));
  // Runs when the timer's handler is queued already.
  asio::post(io, [&reception] { reception.start(); });
  io.poll();
  EXPECT_FALSE(reception.given_up());
  EXPECT_TRUE(test::run_until(io, [&] { return reception.given_up(); }));
}

TEST_F(ReceptionTest, AfterItWasGivenUpOneWhoSendsNothingLeavesItSo) {
  connect(std::string(kFrom0) + "{1}");
  lose();
  EXPECT_TRUE(gives_up());
  EXPECT_EQ(extent(), protocol::Extent::BrokenOff);
  connect(kFrom40);
  EXPECT_EQ(extent(), protocol::Extent::Growing) << "more may come";
  const int before = moments_;
  lose();
  EXPECT_EQ(extent(), protocol::Extent::BrokenOff);
  EXPECT_GT(moments_, before) << "who waited meanwhile is told";
  connect(std::string(kFrom40) + "{2}{3}{-2}");
  EXPECT_TRUE(reception_.whole());
}

/// As a publisher does that offers its recording again: it begins with the keyframes of 0 ms.
TEST_F(ReceptionTest, WhatIsHereWholeDoesNotGoOnWhenItsEndComesAgain) {
  connect(std::string(kFrom0) + "{1;120}{2;0}{-2}");
  ASSERT_TRUE(reception_.whole());
  const test::KeptLog log;
  connect("{hello v=2 window=256 stream=talk duration=120 keyframe=40 from=120}{2;0}");
  EXPECT_FALSE(reception_.status().receiving);
  link_->say("{-2}");
  EXPECT_EQ(log.said(), "");
  EXPECT_EQ(reception_.shared()->recorded()->encoded->times.size(), 2U);
}

}  // namespace
}  // namespace aucast::server
