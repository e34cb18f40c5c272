// The form of a connection by keyboard.
#include <gtest/gtest.h>
#include <imgui.h>

#include "client/gui/texts/texts.h"
#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class Connection : public GuiByHand {};

TEST_F(Connection, AServerIsConnectedTo) {
  ASSERT_TRUE(go_to("##address"));
  type("venus");
  press(ImGuiKey_Enter);
  const auto connect = asked<Connect>();
  ASSERT_TRUE(connect);
  EXPECT_EQ(connect->settings.address, "venus");
}

TEST_F(Connection, HowFarBehindTheServerTheFaceIsIsChosenInWords) {
  ASSERT_TRUE(go_to(tr("play.next_connection")));
  press(ImGuiKey_Enter);
  EXPECT_TRUE(go_to("##threshold")) << "at first in sets";
  const ImGuiID time = ImHashStr(tr("play.behind_time"), 0, id_of("behind"));
  for (int i = 0; i < 200 && focus() != time; ++i) press(ImGuiKey_Tab);
  ASSERT_EQ(focus(), time);
  press(ImGuiKey_Enter);
  EXPECT_FALSE(go_to("##threshold"));
  ASSERT_TRUE(go_to("##behindms"));
  press(ImGuiKey_UpArrow);
  ASSERT_TRUE(go_to(tr("play.connect")));
  press(ImGuiKey_Enter);
  const auto connect = asked<Connect>();
  ASSERT_TRUE(connect);
  EXPECT_EQ(connect->settings.behind, Behind::Time);
  EXPECT_EQ(connect->settings.behind_ms, RemoteSettings().behind_ms + 50);
}

TEST_F(Connection, AFileForTheNextConnectionIsChosenInTheDialog) {
  ASSERT_TRUE(go_to(tr("play.next_connection")));
  press(ImGuiKey_Enter);
  const ImGuiID choose = ImHashStr(tr("button.choose"), 0, id_of(tr("play.token_file")));
  for (int i = 0; i < 200 && focus() != choose; ++i) press(ImGuiKey_Tab);
  ASSERT_EQ(focus(), choose);
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<Browse>());
  EXPECT_EQ(asked<Browse>()->purpose, Purpose::TokenFile);
  model_.credentials.token = "/home/anna/token";
  frames(2);
  ASSERT_TRUE(go_to(tr("play.connect")));
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<Connect>());
  EXPECT_EQ(asked<Connect>()->settings.token_file, "/home/anna/token");
}

}  // namespace
}  // namespace aucast::gui
