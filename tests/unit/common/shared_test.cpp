#include "common/shared.h"

#include <chrono>
#include <stop_token>
#include <string>
#include <thread>

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

TEST(Shared, WaitsNoLongerOnceAStopIsRequested) {
  Shared<int> count;
  const auto never = [](int) { return false; };
  const auto count_on = [](int& value) { return ++value; };
  {
    const auto thread =
        start_thread([&](const std::stop_token& stop) { count.wait(stop, never, count_on); });
    ASSERT_TRUE(thread);
  }  // a std::jthread asks and joins
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(count.wait_until(source.get_token(), steady_clock::time_point::max(), never, count_on),
            2);
}

}  // namespace
}  // namespace aucast
