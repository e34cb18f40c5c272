#include "client/web/browser_sound.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/page/fake_browser.h"

namespace aucast::web {
namespace {

using test::fake_browser;

TEST(BrowserSound, HasHeardWhatIsWrittenLessWhatTheBrowserStillHas) {
  fake_browser() = {};
  BrowserSound sound;
  EXPECT_EQ(sound.heard(), 0);
  sound.write(std::vector<float>{0.1F, 0.2F});
  sound.write(std::vector<float>{0.3F});
  EXPECT_EQ(fake_browser().played, (std::vector<float>{0.1F, 0.2F, 0.3F}));
  fake_browser().unheard = 2;
  EXPECT_EQ(sound.heard(), 1);
  fake_browser().unheard = 0;
  EXPECT_EQ(sound.heard(), 3);
  EXPECT_FALSE(sound.lost());
}

}  // namespace
}  // namespace aucast::web
