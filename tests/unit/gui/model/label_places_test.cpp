#include "client/gui/model/label_places.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

using Places = std::vector<float>;

TEST(LabelPlaces, WhatHasRoomStandsWhereItBelongs) {
  EXPECT_EQ(label_places({}, 10, 0, 100), Places{});
  EXPECT_EQ(label_places({50}, 10, 0, 100), Places{50});
  EXPECT_EQ(label_places({80, 20, 50}, 10, 0, 100), (Places{80, 20, 50}));
}

TEST(LabelPlaces, WhatIsCloseStandsApartInTheSameOrder) {
  EXPECT_EQ(label_places({50, 52, 54}, 10, 0, 100), (Places{50, 60, 70}));
  EXPECT_EQ(label_places({100, 100, 99}, 10, 0, 100), (Places{90, 100, 80}));
  EXPECT_EQ(label_places({0, 0}, 10, 0, 100), (Places{0, 10}));
  EXPECT_EQ(label_places({-20, 200}, 10, 0, 100), (Places{0, 100}));
}

TEST(LabelPlaces, WithoutRoomTheyStandEvenly) {
  EXPECT_EQ(label_places({7, 7, 7}, 10, 0, 10), (Places{0, 5, 10}));
}

}  // namespace
}  // namespace aucast::gui
