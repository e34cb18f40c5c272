#include "server/upstream/redialler.h"

#include <chrono>
#include <memory>
#include <thread>

#include <gtest/gtest.h>
#include <asio/post.hpp>

#include "tests/support/quiet_log.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

/// It may never dial, but asks each time whether it may.
class RediallerTest : public ::testing::Test {
 protected:
  std::unique_ptr<Redialler> make() {
    Redialler::Options options;
    options.hosts = {{"127.0.0.1", 1}};
    options.ready = [this] {
      ++asked_;
      return false;
    };
    return std::make_unique<Redialler>(
        io_, std::move(options), [] { return std::string("talk"); },
        [](std::shared_ptr<link::Link>) {});
  }
  /// `action` is called when the handler of a wait of 1 ms is queued already.
  template <typename Action>
  void too_late_to_cancel(Redialler& redialler, Action action) {
    redialler.again_in(1ms);
    std::this_thread::sleep_for(2ms);
    asio::post(io_, action);
    io_.poll();
  }

  const test::QuietLog quiet_;
  asio::io_context io_;
  int asked_ = 0;
};

TEST_F(RediallerTest, AWaitThatIsOverDoesNotCutTheNextShort) {
  const auto redialler = make();
  too_late_to_cancel(*redialler, [&redialler] { redialler->again_in(10s); });
  EXPECT_EQ(asked_, 0);
}

TEST_F(RediallerTest, MayGoWhenItsWaitIsOver) {
  auto redialler = make();
  too_late_to_cancel(*redialler, [&redialler] { redialler.reset(); });
  EXPECT_EQ(asked_, 0);
}

}  // namespace
}  // namespace aucast::server
