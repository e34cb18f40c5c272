#include "common/files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast {
namespace {

TEST(ReadFile, GivesTheBytes) {
  const test::TempFolder folder;
  const std::string bytes("a\0b\n", 4);
  EXPECT_EQ(read_file(folder.write("x", bytes)).value(), bytes);
}

TEST(ReadFile, NamesFileAndReason) {
  const test::TempFolder folder;
  const auto missing = read_file(folder.path() / "none");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(missing.error().message.find("none: cannot be read: No such file"), std::string::npos);

  const auto directory = read_file(folder.path());
  ASSERT_FALSE(directory.has_value());
  EXPECT_NE(directory.error().message.find("it is a folder"), std::string::npos);
}

TEST(ReadFile, RefusesWhatIsTooLong) {
  const test::TempFolder folder;
  const auto file = folder.write("x", std::string(100, 'x'));
  EXPECT_TRUE(read_file(file, 100).has_value());
  EXPECT_FALSE(read_file(file, 99).has_value());
}

TEST(WriteFileAtomically, ReplacesAndLeavesNothingBeside) {
  const test::TempFolder folder;
  const auto file = folder.write("x", "old");
  ASSERT_TRUE(write_file_atomically(file, "new").has_value());
  EXPECT_EQ(folder.read("x"), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenItFails) {
  const test::TempFolder folder;
  const auto result = write_file_atomically(folder.path() / "missing" / "x", "new");
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().kind, ErrorKind::Failed);
  EXPECT_FALSE(write_file_atomically(folder.path(), "new").has_value());
}

TEST(WriteFileAtomically, SaysThatTheDiskIsFull) {
  const auto result = write_file_atomically("/dev/full", "new");
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(result.error().message.find("No space left"), std::string::npos);
}

TEST(FindDataFolder, TakesTheChosenOneAndNothingElse) {
  const test::TempFolder folder;
  EXPECT_EQ(find_data_folder(folder.path()).value(), folder.path());
  const auto missing = find_data_folder(folder.path() / "none");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(missing.error().message.find("--data"), std::string::npos);
}

}  // namespace
}  // namespace aucast
