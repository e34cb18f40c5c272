// A calibration table that is wrong somewhere is refused with the place, so that no row is measured
// as something else than was meant.

#include <string>

#include <gtest/gtest.h>

#include "tests/golden/calibration.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

constexpr const char* kGood = R"(format = 1
mm_per_unit = 14.0
still_mm = 1.0
[[landmark]]
name = "lip_corner"
patch = "mouth"
ring = 3
spoke = 0
[[landmark]]
name = "inner_brow"
part = "left_brow"
near = [1.0, 4.1, 8.1]
[[au]]
number = 12
sided = true
expect = [{ at = "lip_corner", way = "up", mm = [4.0, 12.0] }]
still = ["inner_brow"]
[end]
)";

std::string replaced(const std::string& old_text, const std::string& new_text) {
  std::string text = kGood;
  const std::size_t at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return text.replace(at, old_text.size(), new_text);
}

/// What is said about a table after the file's name; empty when it is taken.
std::string complaint(const std::string& text) {
  const TempFolder folder;
  const std::filesystem::path file = folder.write("c.toml", text);
  const auto calibration = load_calibration(file);
  if (calibration) return "";
  EXPECT_EQ(calibration.error().kind, ErrorKind::BadData);
  const std::string& message = calibration.error().message;
  EXPECT_TRUE(message.starts_with(file.string() + ":")) << message;
  return message.substr(std::min(message.size(), file.string().size() + 1));
}

TEST(CalibrationFile, IsReadAsWritten) {
  const TempFolder folder;
  const auto calibration = load_calibration(folder.write("c.toml", kGood));
  ASSERT_TRUE(calibration) << calibration.error().message;
  ASSERT_EQ(calibration->landmarks.size(), 2U);
  ASSERT_EQ(calibration->aus.size(), 1U);
  EXPECT_TRUE(calibration->aus[0].sided);
  EXPECT_EQ(calibration->aus[0].expect[0].way, Way::Up);
  EXPECT_EQ(calibration->aus[0].expect[0].most_mm, 12);
  EXPECT_EQ(calibration->aus[0].still, std::vector<std::string>{"inner_brow"});
}

TEST(CalibrationFile, WhatIsWrongIsNamedWithItsPlace) {
  const auto says = [](const std::string& old_text, const std::string& new_text,
                       const std::string& place, const std::string& what) {
    const std::string said = complaint(replaced(old_text, new_text));
    EXPECT_TRUE(said.starts_with(place)) << said;
    EXPECT_NE(said.find(what), std::string::npos) << said;
  };
  says("format = 1", "format = 2", "1:", "format");
  says("mm_per_unit = 14.0", "mm_per_unit = 0.0", "2:", "mm_per_unit");
  says("still_mm = 1.0", "still_mm = nan", "3:", "still_mm");
  says("\"mouth\"", "\"nose\"", "6:", "must be eye or mouth");
  says("ring = 3", "ring = 16", "7:", "ring");
  says("spoke = 0", "", "", "spoke");
  says("[1.0, 4.1, 8.1]", "[1.0, 4.1]", "12:", "near");
  says("number = 12", "number = 0", "14:", "number");
  says("at = \"lip_corner\"", "at = \"lip_corer\"", "16:", "is no landmark");
  says("\"up\"", "\"upwards\"", "16:", "must be up, forward, out or left");
  says("[4.0, 12.0]", "[12.0, 4.0]", "16:", "must be [least, most]");
  says("[4.0, 12.0]", "[4.0, inf]", "16:", "mm");
  says("[\"inner_brow\"]", "[\"inner\"]", "17:", "which is no landmark");
  says("[\"inner_brow\"]", "[7]", "17:", "which is no landmark");
  says("sided = true", "sidde = true", "15:", "sidde");
}

TEST(CalibrationFile, NothingIsThereTwice) {
  EXPECT_NE(complaint(replaced("\"inner_brow\"\npart", "\"lip_corner\"\npart"))
                .find("'lip_corner' is there twice"),
            std::string::npos);
  EXPECT_NE(complaint(std::string(kGood) + "[[au]]\nnumber = 12\nexpect = [{ at = \"lip_corner\", "
                                           "way = \"up\", mm = [4.0, 12.0] }]\n")
                .find("AU 12 is there twice"),
            std::string::npos);
}

TEST(CalibrationFile, AnAuWithoutExpectationsMeasuresNothing) {
  EXPECT_NE(complaint(replaced("expect = [{ at = \"lip_corner\", way = \"up\", mm = [4.0, 12.0] }]",
                               "expect = []"))
                .find("at least one landmark"),
            std::string::npos);
}

TEST(CalibrationFile, WithoutLandmarksOrAusItIsRefused) {
  const std::string head = "format = 1\nmm_per_unit = 14.0\nstill_mm = 1.0\n";
  EXPECT_NE(complaint(head + "[end]\n").find("landmark must be there at least once"),
            std::string::npos);
  const std::string all = kGood;
  const std::string landmarks = all.substr(0, all.find("[[au]]"));
  EXPECT_NE(complaint(landmarks + "[end]\n").find("au must be there at least once"),
            std::string::npos);
}

TEST(CalibrationFile, CutAnywhereItIsRefused) {
  const std::string text = kGood;
  for (std::size_t length = 0; length < text.size() - 1; ++length) {
    EXPECT_NE(complaint(text.substr(0, length)), "") << text.substr(0, length);
  }
  EXPECT_EQ(complaint(text), "");
}

}  // namespace
}  // namespace aucast::test
