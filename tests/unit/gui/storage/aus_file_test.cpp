#include "client/gui/storage/aus_file.h"

#include <gtest/gtest.h>

#include "common/files.h"
#include "tests/support/seeded.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::gui {
namespace {

constexpr std::string_view kFile = R"(# Grüße: a comment at the top

[[au]]
number = 1
drive = { frontalis_inner = 0.15, inner_brow = 1.6 }   # as tuned, öfter
note = "inner brow raiser }"

# Lower face
[[au]]
number = 12
drive={zygomaticus_major=1.05,"a}b"=0.5}
note = "lip corner puller"
)";

std::string changed(std::string_view text, int number, const Drive& drive) {
  auto result = with_au(text, "aus.toml", number, drive);
  EXPECT_TRUE(result) << result.error().message;
  return result ? *result : "";
}

std::string refused(std::string_view text, int number) {
  auto result = with_au(text, "aus.toml", number, {{"jaw", 1.0F}});
  EXPECT_FALSE(result);
  return result ? "" : result.error().message;
}

TEST(AusFile, OnlyTheDriveOfTheAuChanges) {
  EXPECT_EQ(changed(kFile, 1, {{"inner_brow", 0.1F}, {"jaw", 2}}),
            face::test::replaced(std::string(kFile), "{ frontalis_inner = 0.15, inner_brow = 1.6 }",
                                 "{ inner_brow = 0.1, jaw = 2.0 }"));
  EXPECT_EQ(changed(kFile, 12, {}),
            face::test::replaced(std::string(kFile), "{zygomaticus_major=1.05,\"a}b\"=0.5}", "{}"));
}

TEST(AusFile, TheOrderInADriveStays) {
  EXPECT_EQ(changed(kFile, 1, {{"brow", 1}, {"inner_brow", 1.6F}, {"frontalis_inner", 0.2F}}),
            face::test::replaced(std::string(kFile), "{ frontalis_inner = 0.15, inner_brow = 1.6 }",
                                 "{ frontalis_inner = 0.2, inner_brow = 1.6, brow = 1.0 }"));
}

TEST(AusFile, AnAuGetsAnotherName) {
  const auto named = [](int number, const Drive& drive, const std::string& note) {
    const auto text = with_au(kFile, "aus.toml", number, drive, note);
    EXPECT_TRUE(text) << text.error().message;
    return text ? *text : "";
  };
  const Drive drive{{"zygomaticus_major", 1.05F}, {"a}b", 0.5F}};
  EXPECT_EQ(named(12, drive, "mein \"Lächeln\""),
            face::test::replaced(
                face::test::replaced(std::string(kFile), "{zygomaticus_major=1.05,\"a}b\"=0.5}",
                                     "{ zygomaticus_major = 1.05, \"a}b\" = 0.5 }"),
                "\"lip corner puller\"", R"("mein \"Lächeln\"")"));
  EXPECT_EQ(named(77, {{"jaw", 1}}, "mine"),
            std::string(kFile) + "\n[[au]]\nnumber = 77\ndrive = { jaw = 1.0 }\nnote = \"mine\"\n");
  const std::string bare = "[[au]]\nnumber = 77\ndrive = { jaw = 1.0 } # so far\n";
  EXPECT_EQ(*with_au(bare, "aus.toml", 77, {{"jaw", 1}}, "mine"), bare + "note = \"mine\"\n");
}

TEST(AusFile, AnAuIsTakenOutAndNothingElse) {
  const auto without = [](std::string_view text, int number) {
    const auto left = without_au(text, "aus.toml", number);
    EXPECT_TRUE(left) << left.error().message;
    return left ? *left : "";
  };
  EXPECT_EQ(without(kFile, 77), kFile);
  EXPECT_EQ(without(kFile, 1),
            "# Grüße: a comment at the top\n\n# Lower face\n[[au]]\nnumber = 12\n"
            "drive={zygomaticus_major=1.05,\"a}b\"=0.5}\nnote = \"lip corner puller\"\n");
  EXPECT_EQ(without(changed(kFile, 77, {{"jaw", 1}}), 77), kFile)
      << "as it was before it was saved";
  const std::string short_file = "[[au]]\nnumber = 3\ndrive = {}";
  EXPECT_EQ(without(short_file, 3), "");
  const auto refused = without_au("au = [ { number = 4, drive = {} } ]\n", "aus.toml", 4);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("does not begin with a line [[au]]"), std::string::npos);
}

TEST(AusFile, TextBeforeTheDriveMayBeOfAnyLanguage) {
  const std::string text = "[[au]]\n\"number\" = 3\n";
  const std::string line = "au = [ { note = \"größer\", number = 4, drive = { jaw = 1.0 } } ]\n";
  EXPECT_EQ(changed(line, 4, {{"jaw", 0.5F}}),
            face::test::replaced(line, "{ jaw = 1.0 }", "{ jaw = 0.5 }"));
  EXPECT_NE(refused(text, 3).find("aus.toml:1:1: AU3 has no drive"), std::string::npos);
}

TEST(AusFile, ANewAuGoesToTheEnd) {
  EXPECT_EQ(changed(kFile, 77, {{"jaw", 1.5F}}),
            std::string(kFile) + "\n[[au]]\nnumber = 77\ndrive = { jaw = 1.5 }\n");
  EXPECT_EQ(changed("", 26, {{"jaw", 1}}),
            "[[au]]\nnumber = 26\ndrive = { jaw = 1.0 }\nnote = \"Jaw Drop\"\n");
  EXPECT_EQ(changed("# no end of line", 77, {}),
            "# no end of line\n\n[[au]]\nnumber = 77\ndrive = {}\n");
}

TEST(AusFile, WindowsEndsOfLinesStay) {
  const std::string text = "[[au]]\r\nnumber = 1\r\ndrive = { jaw = 1.0 }\r\nnote = \"x\"\r\n";
  EXPECT_EQ(changed(text, 1, {{"jaw", 2}}), face::test::replaced(text, "1.0", "2.0"));
}

TEST(AusFile, ADriveOverSeveralLinesIsNotTouched) {
  EXPECT_EQ(refused("[[au]]\nnumber = 1\n[au.drive]\njaw = 1.0\n", 1).substr(0, 35),
            "aus.toml:3:5: the drive of AU1 is n");
}

TEST(AusFile, WhatIsNoTomlIsRefusedWithItsPlace) {
  EXPECT_EQ(refused("[[au]]\nnumber = = 1\n", 1).substr(0, 11), "aus.toml:2:");
}

TEST(AusFile, SidesThatAreAlikeAreWrittenOnce) {
  const face::Face face = face::test::small_face();
  std::vector<float> activations(face.channels.size());
  EXPECT_TRUE(drive_of(face, activations).empty());
  activations[*face.channel_index("left_lid_close")] = 0.5F;
  activations[*face.channel_index("right_lid_close")] = 0.5F;
  activations[*face.channel_index("jaw")] = 1.5F;
  EXPECT_EQ(drive_of(face, activations), (Drive{{"jaw", 1.5F}, {"lid_close", 0.5F}}));
  activations[*face.channel_index("right_lid_close")] = 0;
  EXPECT_EQ(drive_of(face, activations), (Drive{{"jaw", 1.5F}, {"left_lid_close", 0.5F}}));
  activations[*face.channel_index("right_lid_close")] = 0.25F;
  EXPECT_EQ(drive_of(face, activations),
            (Drive{{"jaw", 1.5F}, {"left_lid_close", 0.5F}, {"right_lid_close", 0.25F}}));
}

/// Whatever is set in the editor, a face that loads the file afterwards does exactly that.
TEST(AusFile, WhatIsWrittenIsReadBackBitForBit) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  test::TempFolder folder;
  face::test::write_small_face(folder);
  const face::Face face = face::test::small_face();
  std::string text = folder.read("aus.toml");
  for (int round = 0; round < 20; ++round) {
    std::vector<float> activations(face.channels.size());
    for (std::size_t i = 0; i < activations.size(); ++i) {
      if (seeded.chance(0.5)) continue;
      activations[i] = static_cast<float>(seeded.real(0, 1)) * face.channels[i].activation_max;
      const std::string& name = face.channels[i].name;
      if (!name.starts_with("right_") || seeded.chance(0.3)) continue;
      if (const auto left = face.channel_index("left_" + name.substr(6))) {
        activations[*left] = activations[i];
      }
    }
    const int number = seeded.integer(1, kAuNumberMax);
    text = changed(text, number, drive_of(face, activations));
    folder.write("aus.toml", text);
    const auto loaded = face::load_face(folder.path(), folder.path());
    ASSERT_TRUE(loaded) << loaded.error().message;
    ASSERT_EQ(loaded->recordings.at(number).activation, activations);
  }
}

}  // namespace
}  // namespace aucast::gui
