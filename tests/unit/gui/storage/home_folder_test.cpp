#include "client/gui/storage/home_folder.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

TEST(HomeFolder, ATildeAtTheBeginningOfAPathIsTheHomeFolder) {
  EXPECT_EQ(with_home("~", "/home/a"), "/home/a");
  EXPECT_EQ(with_home("~/", "/home/a"), "/home/a/");
  EXPECT_EQ(with_home("~/faces/lara.csv", "/home/a"), "/home/a/faces/lara.csv");
  EXPECT_EQ(with_home("~/lara.csv", "/home/a/"), "/home/a/lara.csv");
  EXPECT_EQ(with_home("~/lara.csv", "/"), "/lara.csv");
  EXPECT_EQ(with_home("~", "/"), "/");
}

TEST(HomeFolder, AnyOtherTildeIsPartOfAName) {
  for (const char* typed : {"", "./~", "./~/lara.csv", "~lara", "~~", "a/~/b", "lara.csv~", "/~"}) {
    EXPECT_EQ(with_home(typed, "/home/a"), typed);
  }
}

TEST(HomeFolder, WithoutAHomeFolderATildeStaysOne) {
  for (const char* home : {static_cast<const char*>(nullptr), "", "home/a"}) {
    EXPECT_EQ(with_home("~/lara.csv", home), "~/lara.csv");
  }
}

}  // namespace
}  // namespace aucast::gui
