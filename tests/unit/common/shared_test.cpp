#include "common/shared.h"

#include <chrono>
#include <string>

#include <gtest/gtest.h>

#include "common/thread.h"

namespace aucast {
namespace {

using std::chrono::steady_clock;

TEST(Shared, WakesWhoWaitsWhenItIsChanged) {
  Shared<std::string> word;
  std::string heard;
  {
    auto thread = start_thread([&] {
      heard = word.wait([](const std::string& text) { return !text.empty(); },
                        [](std::string& text) { return std::exchange(text, "taken"); });
    });
    ASSERT_TRUE(thread);
    word.change([](std::string& text) { text = "said"; });
    thread->join();
  }
  EXPECT_EQ(heard, "said");
  EXPECT_EQ(word.with([](const std::string& text) { return text; }), "taken");
}

TEST(Shared, WaitsNoLongerThanItWasTold) {
  Shared<int> count(3);
  const auto four = [](int value) { return value == 4; };
  EXPECT_FALSE(count.wait_until(steady_clock::now(), four, four));
  count.change([](int& value) { ++value; });
  EXPECT_TRUE(count.wait_until(steady_clock::now(), four, four));
}

}  // namespace
}  // namespace aucast
