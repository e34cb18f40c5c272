#include "client/app/window/making/au_names.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

using Names = std::map<int, std::string>;

TEST(AuNames, AnAuIsSavedUnderWhatIsWantedElseUnderWhatWasTyped) {
  AuNames names;
  EXPECT_EQ(names.name_for(70, ""), "");
  names.type(70, " My smile ", "");
  EXPECT_TRUE(names.unsaved());
  EXPECT_EQ(names.view(), (Names{{70, " My smile "}})) << "as the field shows it";
  EXPECT_EQ(names.name_for(70, ""), "My smile");
  EXPECT_EQ(names.name_for(70, "Another"), "Another");
  EXPECT_EQ(names.name_for(71, ""), "");
  names.saved(70);
  EXPECT_FALSE(names.unsaved());
  EXPECT_EQ(names.name_for(70, ""), "");
}

TEST(AuNames, TheNameThatItHasIsNoChange) {
  AuNames names;
  names.type(70, "My smil", "My smile");
  EXPECT_TRUE(names.unsaved());
  names.type(70, "My smile", "My smile");
  EXPECT_FALSE(names.unsaved());
}

TEST(AuNames, AnAuThatWasRemovedKeepsItsNameInCaseItIsSavedAgain) {
  AuNames names;
  names.type(70, "My grin", "My smile");
  names.removed(70, "My smile");
  EXPECT_FALSE(names.unsaved()) << "nobody is asked about it when leaving";
  EXPECT_EQ(names.view(), (Names{{70, "My smile"}}));
  EXPECT_EQ(names.name_for(70, ""), "My smile");
  names.type(70, "", "");
  EXPECT_EQ(names.name_for(70, ""), "") << "a name that was cleared";
  names.removed(70, "My smile");
  names.change_face();
  EXPECT_EQ(names.view(), Names());
}

TEST(AuNames, RevertForgetsWhatWasTyped) {
  AuNames names;
  names.removed(70, "My smile");
  names.type(71, "My grin", "");
  names.revert();
  EXPECT_EQ(names.view(), (Names{{70, "My smile"}}));
}

}  // namespace
}  // namespace aucast::app
