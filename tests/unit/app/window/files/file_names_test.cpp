#include "client/app/window/files/file_names.h"

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

TEST(FileNames, AreThoseOfTheStreamThatPlays) {
  Named shown;
  shown.face = "marek";
  shown.stream = "talk";
  EXPECT_EQ(new_file_name(gui::Purpose::ExportKeyframes, shown), "talk_played.txt")
      << "the stream itself is beside it";
  EXPECT_EQ(new_file_name(gui::Purpose::ExportTable, shown), "talk.csv");
  EXPECT_EQ(new_file_name(gui::Purpose::ExportMesh, shown), "talk.obj");
  EXPECT_EQ(new_file_name(gui::Purpose::ExportGlb, shown), "talk.glb");
}

TEST(FileNames, AreThoseOfTheFaceWhenNothingPlays) {
  Named shown;
  shown.face = "marek";
  shown.au = 12;
  EXPECT_EQ(new_file_name(gui::Purpose::ExportKeyframes, shown), "played.txt");
  EXPECT_EQ(new_file_name(gui::Purpose::ExportTable, shown), "played.csv");
  EXPECT_EQ(new_file_name(gui::Purpose::ExportMesh, shown), "marek.obj");
  EXPECT_EQ(new_file_name(gui::Purpose::ExportGlb, shown), "marek.glb");
  EXPECT_EQ(new_file_name(gui::Purpose::ExportAu, shown), "au12.toml");
}

TEST(FileNames, ACompositionKeepsItsOwn) {
  Named shown;
  EXPECT_EQ(new_file_name(gui::Purpose::SaveStream, shown), "composed.txt");
  shown.composition = "somewhere/greeting.txt";
  EXPECT_EQ(new_file_name(gui::Purpose::SaveStream, shown), "greeting.txt");
}

TEST(FileNames, APictureIsNamedAfterWhatIsShown) {
  const test::TempFolder folder;
  gui::PictureSettings settings;
  settings.folder = folder.path().string();
  settings.pattern = "{face}_{stream}_{keyframe}_{aus}";
  Named shown;
  shown.face = "marek";
  shown.stream = "talk";
  shown.keyframe = 7;
  shown.aus = *protocol::parse_au_set("6,12:80");
  shown.edited = "au12_edited";
  const auto of_aus = new_picture_file(settings, shown, "2026-11-30", ".png");
  ASSERT_TRUE(of_aus) << of_aus.error().message;
  EXPECT_EQ(of_aus->filename(), "marek_talk_7_au06_au12-80.png");
  shown.aus.reset();
  shown.keyframe = 0;
  const auto of_muscles = new_picture_file(settings, shown, "2026-11-30", ".png");
  ASSERT_TRUE(of_muscles) << of_muscles.error().message;
  EXPECT_EQ(of_muscles->filename(), "marek_talk_none_au12_edited.png");
}

TEST(FileNames, APictureHasTheDateThatItIsGiven) {
  const test::TempFolder folder;
  gui::PictureSettings settings;
  settings.folder = folder.path().string();
  settings.pattern = "{date}_{face}";
  Named shown;
  shown.face = "marek";
  const auto file = new_picture_file(settings, shown, "1999-12-31", ".png");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->filename(), "1999-12-31_marek.png");
}

TEST(FileNames, APictureThatIsThereIsNeverOverwritten) {
  const test::TempFolder folder;
  gui::PictureSettings settings;
  settings.folder = folder.path() / "new" / "pictures";
  Named shown;
  shown.face = "marek";
  const auto next = [&] {
    const auto file = new_picture_file(settings, shown, "2026-11-30", ".png");
    EXPECT_TRUE(file) << file.error().message;
    return file ? file->filename().string() : "";
  };
  EXPECT_EQ(next(), "face-player-1.png") << "the folder is made";
  folder.write("new/pictures/face-player-1.png", "");
  folder.write("new/pictures/face-player-2.png", "");
  EXPECT_EQ(next(), "face-player-3.png");
  settings.pattern = "{face}";
  EXPECT_EQ(next(), "marek.png");
  folder.write("new/pictures/marek.png", "");
  EXPECT_EQ(next(), "marek-2.png");
  settings.folder = folder.path() / "new" / "pictures" / "marek.png";
  const auto none = new_picture_file(settings, shown, "2026-11-30", ".png");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("cannot make"), std::string::npos);
}

}  // namespace
}  // namespace aucast::app
