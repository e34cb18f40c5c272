#include "common/files_together.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iterator>

#include "tests/support/temp_folder.h"

namespace aucast {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t files_in(const fs::path& folder) {
  const fs::directory_iterator files(folder);
  return std::distance(begin(files), end(files));
}

TEST(FilesTogether, GetTheirNamesWhenAllHaveBeenWritten) {
  const test::TempFolder folder;
  folder.write("a", "old");
  FilesTogether files;
  ASSERT_TRUE(files.add(folder.path() / "a", "new a"));
  ASSERT_TRUE(files.add(folder.path() / "b", [](const FilesTogether::Append& append) {
    append("new");
    append({"\0b", 2});
  }));
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_FALSE(fs::exists(folder.path() / "b"));
  ASSERT_TRUE(files.finish());
  EXPECT_EQ(folder.read("a"), "new a");
  EXPECT_EQ(folder.read("b"), std::string("new\0b", 5));
  EXPECT_EQ(files_in(folder.path()), 2);
}

TEST(FilesTogether, LeaveNothingWhereOneCannotBeWritten) {
  const test::TempFolder folder;
  {
    FilesTogether files;
    ASSERT_TRUE(files.add(folder.path() / "a", "a"));
    const auto missing = files.add(folder.path() / "none" / "b", "b");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::Failed);
    const auto into_folder = files.add(folder.path(), "c");
    ASSERT_FALSE(into_folder);
    EXPECT_EQ(into_folder.error().message,
              folder.path().string() + ": cannot be written: it is a folder");
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

/// What RLIMIT_FSIZE does to a write is what a full disk does: it fails half-way.
void fill(const fs::path& path, std::size_t portions) {
  const rlimit limit{16'384, 16'384};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, SIG_IGN);
  FilesTogether files;
  const auto added = files.add(path, [portions](const FilesTogether::Append& append) {
    for (std::size_t i = 0; i < portions; ++i) append(std::string(1000, 'x'));
  });
  if (!added) std::fprintf(stderr, "%s\n", added.error().message.c_str());
  std::_Exit(added ? 0 : 7);
}

TEST(FilesTogether, TellWhyAFileIsNotWhole) {
  const test::TempFolder folder;
  const auto path = folder.path() / "a";
  EXPECT_EXIT(fill(path, 16), testing::ExitedWithCode(0), "");
  // In a portion, and in what is left for the end.
  for (const std::size_t portions : {200U, 17U}) {
    EXPECT_EXIT(fill(path, portions), testing::ExitedWithCode(7),
                "a: cannot be written whole: File too large");
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(FilesTogether, WhatIsNoFileIsWrittenWithTheOthers) {
  const test::TempFolder folder;
  const auto fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const auto written = [&] {
    FilesTogether files;
    EXPECT_TRUE(files.add(folder.path() / "a", "a"));
    EXPECT_TRUE(files.add(fifo, "through"));
    EXPECT_TRUE(files.add("/dev/null", "nowhere"));
    return files.finish();
  };
  EXPECT_FALSE(written()) << "nobody reads it";
  EXPECT_EQ(files_in(folder.path()), 1) << "the FIFO; and not a file that goes with it";
  const int reader = ::open(fifo.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(written());
  char bytes[16];
  EXPECT_EQ(::read(reader, bytes, sizeof bytes), 7);
  EXPECT_EQ(std::string(bytes, 7), "through");
  EXPECT_EQ(folder.read("a"), "a");
  EXPECT_TRUE(fs::is_fifo(fifo)) << "no file has taken its place";
  ::close(reader);
}

}  // namespace
}  // namespace aucast
