#include "client/gui/model/mirror_view.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

TEST(MirrorView, AusAreBarsToBothSides) {
  const std::vector<AuTerm> aus{{1, Side::Left, 10},
                                {1, Side::Right, 0},
                                {12, Side::Left, 30},
                                {12, Side::Right, 50},
                                {26, Side::Both, 70}};
  const std::vector<AuBar> expected{
      {"1 Inner Brow Raiser", 10, 0}, {"12 Lip Corner Puller", 30, 50}, {"26 Jaw Drop", 70, 70}};
  EXPECT_EQ(au_bars(aus), expected);
  EXPECT_TRUE(au_bars({}).empty());
}

TEST(MirrorView, TurnsAreOneBarForBothWays) {
  const std::vector<AuTerm> aus{
      {61, Side::Both, 5}, {51, Side::Both, 0}, {52, Side::Both, 40}, {62, Side::Both, 0}};
  const std::vector<AuBar> expected{{"51 52 Head Left, Right", 0, 40},
                                    {"61 62 Eyes Left, Right", 5, 0}};
  EXPECT_EQ(au_bars(aus), expected);
}

TEST(MirrorView, SaysWhoSeesTheFace) {
  MirrorView view;
  EXPECT_EQ(viewers_text(view), "The camera is off.");
  view.phase = MirrorView::Phase::Private;
  EXPECT_EQ(viewers_text(view), "Only you see this face.");
  view.phase = MirrorView::Phase::Live;
  view.live = "10.0.0.7:4650";
  EXPECT_EQ(viewers_text(view), "Live at 10.0.0.7:4650, nobody watches yet.");
  view.watching = 1;
  EXPECT_EQ(viewers_text(view), "Live at 10.0.0.7:4650, 1 watches.");
  view.watching = 2;
  EXPECT_EQ(viewers_text(view), "Live at 10.0.0.7:4650, 2 watch.");
}

TEST(MirrorView, SaysWhatOthersNeed) {
  MirrorView view;
  EXPECT_EQ(admission_text(view), "Others need the address only, no token.");
  view.asks_tls = true;
  EXPECT_EQ(admission_text(view),
            "Others need the address only, no token. They must connect with TLS.");
  view.asks_token = true;
  EXPECT_EQ(admission_text(view),
            "Others need the address and your token. They must connect with TLS.");
  view.asks_tls = false;
  EXPECT_EQ(admission_text(view), "Others need the address and your token.");
}

}  // namespace
}  // namespace aucast::gui
