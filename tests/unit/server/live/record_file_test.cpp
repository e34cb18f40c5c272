#include "server/live/record_file.h"

#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/shared.h"
#include "tests/support/temp_folder.h"

// Linked before the system's own: what is synced is noted, and a test can have a lock fail.

namespace {

std::atomic<int> lock_error{0};
/// What another program does between opening and locking.
std::function<void()> before_lock;

aucast::Shared<std::vector<std::filesystem::path>>& synced() {
  static aucast::Shared<std::vector<std::filesystem::path>> paths;
  return paths;
}

}  // namespace

extern "C" int fsync(int descriptor) {
  std::error_code none;
  const auto path =
      std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), none);
  synced().with([&](auto& paths) { paths.push_back(path); });
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

extern "C" int flock(int descriptor, int operation) noexcept {
  if (before_lock) before_lock();
  if (lock_error == 0) return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
  errno = lock_error;
  return -1;
}

namespace aucast::server {
namespace {

using test::TempFolder;

class RecordFileTest : public ::testing::Test {
 protected:
  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "kept.txt";
};

TEST_F(RecordFileTest, IsAWholeStreamFileAfterEveryLine) {
  auto file = RecordFile::create(path_);
  ASSERT_TRUE(file) << file.error().message;
  std::string lines;
  for (const char* line : {"12:20;40\n", "12;33\n", "0;3600000\n"}) {
    lines += line;
    ASSERT_TRUE(file->add(line));
    EXPECT_EQ(folder_.read("kept.txt"), "Beg_Stream\n" + lines + "End_Stream\n");
  }
  EXPECT_TRUE(file->sync());
}

TEST_F(RecordFileTest, WithoutALineThereIsNoFile) {
  {
    auto file = RecordFile::create(path_);
    ASSERT_TRUE(file);
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(RecordFileTest, AnEmptyFileThatWasThereStays) {
  folder_.write("kept.txt", "");
  EXPECT_TRUE(RecordFile::create(path_));
  EXPECT_TRUE(std::filesystem::exists(path_));
}

TEST_F(RecordFileTest, WhereNoFileCanBeMadeAnotherPlaceIsAskedFor) {
  const auto nowhere = folder_.path() / "none" / "kept.txt";
  EXPECT_EQ(RecordFile::create(nowhere).error(),
            (Error{ErrorKind::Failed, nowhere.string() +
                                          ": cannot be recorded to: No such file or directory; "
                                          "choose another place"}));
}

TEST_F(RecordFileTest, WhatIsThereIsNeverWrittenOver) {
  folder_.write("kept.txt", "yesterday");
  EXPECT_EQ(RecordFile::create(path_).error(),
            (Error{ErrorKind::Failed, path_.string() +
                                          ": cannot be recorded to: it holds something already, "
                                          "which --record never writes over"}));
  EXPECT_EQ(folder_.read("kept.txt"), "yesterday");
  folder_.write("kept.txt", "");
  EXPECT_TRUE(RecordFile::create(path_));
}

TEST_F(RecordFileTest, TwoCannotWriteToOne) {
  const auto first = RecordFile::create(path_);
  ASSERT_TRUE(first);
  const auto second = RecordFile::create(path_);
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("another program is recording to it"), std::string::npos);
}

TEST_F(RecordFileTest, IsSyncedTogetherWithItsName) {
  const auto times = [this] {
    return synced().with([this](const auto& paths) {
      return std::count(paths.begin(), paths.end(), folder_.path());
    });
  };
  auto file = RecordFile::create(path_);
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->add("12;40\n"));
  EXPECT_TRUE(file->sync());
  EXPECT_EQ(times(), 1);
  ASSERT_TRUE(file->add("0;40\n"));
  EXPECT_TRUE(file->sync());
  EXPECT_EQ(times(), 1) << "that lasts";
}

TEST_F(RecordFileTest, WhatCannotBeLockedLeavesNoFile) {
  lock_error = ENOLCK;
  const auto file = RecordFile::create(path_);
  EXPECT_FALSE(std::filesystem::exists(path_));
  folder_.write("kept.txt", "");
  EXPECT_FALSE(RecordFile::create(path_));
  lock_error = 0;
  EXPECT_TRUE(std::filesystem::exists(path_)) << "it was there before";
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error(),
            (Error{ErrorKind::Failed, path_.string() +
                                          ": cannot be recorded to: it cannot be locked: No locks "
                                          "available; record to a disk of this computer"}));
}

TEST_F(RecordFileTest, AFileThatAnotherProgramWasQuickerToLockStays) {
  lock_error = EWOULDBLOCK;
  const auto file = RecordFile::create(path_);
  lock_error = 0;
  EXPECT_TRUE(std::filesystem::exists(path_));
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("another program is recording to it"), std::string::npos);
}

TEST_F(RecordFileTest, WhatIsWrittenBeforeItIsLockedIsNotWrittenOver) {
  before_lock = [this] { folder_.write("kept.txt", "another's"); };
  const auto file = RecordFile::create(path_);
  before_lock = {};
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("it holds something already"), std::string::npos);
  EXPECT_EQ(folder_.read("kept.txt"), "another's");
}

TEST_F(RecordFileTest, AFileThatIsRemovedBeforeItIsLockedIsMadeAnew) {
  int times = 0;
  before_lock = [&] {
    if (++times == 1) std::filesystem::remove(path_);
  };
  auto file = RecordFile::create(path_);
  before_lock = {};
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_TRUE(file->add("12;40\n"));
  EXPECT_EQ(folder_.read("kept.txt"), "Beg_Stream\n12;40\nEnd_Stream\n");
  EXPECT_EQ(times, 2);
}

TEST_F(RecordFileTest, AFileThatIsAlwaysRemovedIsAnError) {
  before_lock = [this] { std::filesystem::remove(path_); };
  const auto file = RecordFile::create(path_);
  before_lock = {};
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("removes it again and again"), std::string::npos);
}

TEST_F(RecordFileTest, OnlyPlainFilesAreTaken) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  EXPECT_FALSE(RecordFile::create(path_));
  EXPECT_EQ(RecordFile::create("/dev/full").error(),
            (Error{ErrorKind::Failed,
                   "/dev/full: cannot be recorded to: it is no plain file; give --record a new "
                   "file, or a folder that is there"}));
  EXPECT_FALSE(RecordFile::create(folder_.path() / "no" / "kept.txt"));
  EXPECT_FALSE(RecordFile::create(folder_.path()));
}

}  // namespace
}  // namespace aucast::server
