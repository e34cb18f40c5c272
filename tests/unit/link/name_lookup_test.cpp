#include "common/link/name_lookup.h"

#include <atomic>
#include <memory>
#include <semaphore>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_until.h"

namespace aucast::link {
namespace {

using aucast::test::run_until;

/// A resolver that hangs until it is let go. It may outlive the test, as its threads may.
struct Resolver {
  std::atomic<int> asked{0};
  std::counting_semaphore<> go_on{0};
};

class NameLookupTest : public ::testing::Test {
 protected:
  ~NameLookupTest() override { resolver_->go_on.release(resolver_->asked); }

  void ask(const std::string& host, std::uint16_t port) {
    lookup_.start(host, port, [this, host](const std::string& failure, const Addresses& found) {
      for (const auto& endpoint : found) {
        told_.push_back(host + ' ' + endpoint.address().to_string() + ' ' +
                        std::to_string(endpoint.port()));
      }
      if (!failure.empty()) told_.push_back(host + ' ' + failure);
    });
  }
  [[nodiscard]] bool is_told() {
    return run_until(io_, [this] { return !told_.empty(); });
  }

  asio::io_context io_;
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  std::shared_ptr<Resolver> resolver_ = std::make_shared<Resolver>();
  NameLookup lookup_{io_, [resolver = resolver_](const std::string& host, Addresses& found) {
                       ++resolver->asked;
                       resolver->go_on.acquire();
                       if (host == "nowhere.test") return std::string("no such host");
                       found = {{asio::ip::make_address("192.0.2.7"), 0}};
                       return std::string();
                     }};
  std::vector<std::string> told_;
};

TEST_F(NameLookupTest, AResolverThatHangsIsAskedOnceForEachHost) {
  for (std::uint16_t port = 1; port <= 100; ++port) {
    ask("a.test", port);
    lookup_.cancel();
    ask("nowhere.test", port);
  }
  ask("a.test", 900);
  ASSERT_TRUE(run_until(io_, [this] { return resolver_->asked == 2; }));
  resolver_->go_on.release(2);
  EXPECT_TRUE(is_told());
  EXPECT_EQ(told_, std::vector<std::string>{"a.test 192.0.2.7 900"});
  EXPECT_EQ(resolver_->asked, 2);

  told_.clear();
  ask("nowhere.test", 1);
  resolver_->go_on.release(2);
  EXPECT_TRUE(is_told());
  EXPECT_EQ(told_, std::vector<std::string>{"nowhere.test no such host"});
}

TEST_F(NameLookupTest, ALateAnswerIsNoneToAnotherQuestion) {
  ask("a.test", 1);
  ask("127.0.0.1", 2);
  EXPECT_TRUE(is_told());
  ask("nowhere.test", 3);
  ask("127.0.0.1", 4);
  lookup_.cancel();
  ASSERT_TRUE(run_until(io_, [this] { return resolver_->asked == 2; }));
  resolver_->go_on.release(2);
  ask("127.0.0.2", 5);
  EXPECT_TRUE(run_until(io_, [this] { return told_.size() == 2; }));
  EXPECT_EQ(told_, (std::vector<std::string>{"127.0.0.1 127.0.0.1 2", "127.0.0.2 127.0.0.2 5"}));
}

TEST_F(NameLookupTest, MayEndBeforeItsResolver) {
  auto brief = std::make_unique<NameLookup>(io_, [resolver = resolver_](const auto&, auto&) {
    ++resolver->asked;
    resolver->go_on.acquire();
    return std::string("late");
  });
  brief->start("a.test", 1, [this](const std::string& failure, auto) { told_.push_back(failure); });
  ASSERT_TRUE(run_until(io_, [this] { return resolver_->asked == 1; }));
  brief.reset();
  resolver_->go_on.release();
  ask("127.0.0.1", 2);
  EXPECT_TRUE(is_told());
  EXPECT_EQ(told_, std::vector<std::string>{"127.0.0.1 127.0.0.1 2"});
}

}  // namespace
}  // namespace aucast::link
