#include "common/overwriting.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast {
namespace {

TEST(CheckNotRead, RefusesAnInputByItsNameAndByThatOfALink) {
  const test::TempFolder folder;
  const auto input = folder.write("in.txt", "x");
  const auto soft = folder.path() / "soft";
  const auto hard = folder.path() / "hard";
  std::filesystem::create_symlink(input, soft);
  std::filesystem::create_hard_link(input, hard);
  for (const auto& output : {input, folder.path() / "." / "in.txt", soft, hard}) {
    const auto checked = check_not_read({folder.path() / "new", output}, {"", input});
    ASSERT_FALSE(checked.has_value()) << output;
    EXPECT_EQ(checked.error().kind, ErrorKind::Usage);
    EXPECT_EQ(checked.error().message, output.string() + " would be written over " +
                                           input.string() +
                                           ", which is read; choose another name or folder");
  }
}

TEST(CheckNotRead, LetsOtherFilesBeWritten) {
  const test::TempFolder folder;
  const auto input = folder.write("in.txt", "x");
  const auto other = folder.write("other.txt", "x");
  EXPECT_TRUE(check_not_read({other, folder.path() / "new", "", "-", folder.path()},
                             {input, folder.path() / "none", "", "-", folder.path()}));
  EXPECT_TRUE(check_not_read({"/dev/null"}, {"/dev/null"}));
}

TEST(CheckDistinct, RefusesOneFileTwice) {
  const test::TempFolder folder;
  const auto there = folder.write("there.txt", "x");
  const auto link = folder.path() / "link";
  std::filesystem::create_symlink(there, link);
  const auto fresh = folder.path() / "new";
  for (const auto& again : {fresh, folder.path() / "none" / ".." / "new", there, link}) {
    const auto checked = check_distinct({fresh, "", there, again});
    ASSERT_FALSE(checked.has_value()) << again;
    EXPECT_EQ(checked.error(),
              (Error{ErrorKind::Usage, again.string() +
                                           " would be written twice, for two options; choose "
                                           "another name for one of them"}));
  }
  EXPECT_FALSE(check_distinct({"none", "./none"}));
}

TEST(CheckDistinct, LetsOtherFilesBeWritten) {
  const test::TempFolder folder;
  EXPECT_TRUE(check_distinct({folder.path() / "a", folder.path() / "b", "", "", "-", "-"}));
  EXPECT_TRUE(check_distinct({"/dev/null", "/dev/null"}));
  const auto loop = folder.path() / "loop";
  std::filesystem::create_symlink("loop", loop);
  EXPECT_TRUE(check_distinct({loop / "a", loop / "b"}));
}

}  // namespace
}  // namespace aucast
