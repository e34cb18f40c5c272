#include "client/app/start_times.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

TEST(StartTimes, TheStagesAddUpToTheWhole) {
  StartTimes times;
  times.passed("session");
  times.passed("window");
  const std::string text = times.text();
  EXPECT_EQ(text.find("first picture after "), 0U) << text;
  double sum = 0;
  for (const char* stage : {"options and files ", "session ", "window "}) {
    const std::size_t at = text.find(stage);
    ASSERT_NE(at, std::string::npos) << text;
    sum += std::stod(text.substr(at + std::string(stage).size()));
  }
  EXPECT_NEAR(std::stod(text.substr(20)), sum, 2) << text;
}

}  // namespace
}  // namespace aucast::app
