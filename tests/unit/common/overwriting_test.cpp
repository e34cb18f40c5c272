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

}  // namespace
}  // namespace aucast
