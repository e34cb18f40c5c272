#include "common/task.h"

#include <future>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(Task, AnswersOnceAndCanBeStartedAgain) {
  Task<std::string> task;
  EXPECT_FALSE(task.running());
  EXPECT_FALSE(task.take());
  for (const std::string word : {"one", "two"}) {
    ASSERT_TRUE(task.start([word] { return word; }));
    EXPECT_TRUE(task.running());
    task.wait();
    EXPECT_EQ(task.take(), word);
    EXPECT_FALSE(task.running());
    EXPECT_FALSE(task.take());
  }
}

TEST(Task, HasNoAnswerWhileItRuns) {
  std::promise<int> given;
  Task<int> task;
  ASSERT_TRUE(task.start([&given] { return given.get_future().get(); }));
  EXPECT_FALSE(task.take());
  EXPECT_TRUE(task.running());
  given.set_value(3);
  task.wait();
  EXPECT_EQ(task.take(), 3);
}

TEST(Task, WhatTheWorkHeldIsGoneWhenItsAnswerIsTaken) {
  const auto held = std::make_shared<int>(4);
  Task<int> task;
  ASSERT_TRUE(task.start([held] { return *held; }));
  task.wait();
  EXPECT_EQ(task.take(), 4);
  EXPECT_EQ(held.use_count(), 1);
}

TEST(Task, ItsEndWaitsForTheWork) {
  std::promise<void> gone;
  bool done = false;
  {
    Task<int> task;
    ASSERT_TRUE(task.start([&] {
      gone.get_future().wait();
      done = true;
      return 0;
    }));
    gone.set_value();
  }
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace aucast
