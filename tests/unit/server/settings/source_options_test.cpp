#include "server/settings/source_options.h"

#include <string>

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

Result<SourceOptions> read_source(const TypedWords& words) {
  SourceOptions options;
  const auto rows = recording_rows(options);
  if (auto done = read_words(rows, words); !done) return done.error();
  return options;
}

std::string source_message(const std::string& name, const std::string& word) {
  const auto options = read_source({{name, {word}}});
  if (options) return "accepted";
  EXPECT_EQ(options.error().kind, ErrorKind::Usage);
  return options.error().message;
}

TEST(SourceOptions, AreRead) {
  EXPECT_EQ(*read_source({}), SourceOptions());
  const auto all = read_source({{"fps", {"29.97"}},
                                {"au-scale", {"100"}},
                                {"face-id", {"-3"}},
                                {"min-confidence", {"0.8"}},
                                {"rate", {"12.5"}}});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->recording.fps, 29.97);
  EXPECT_EQ(all->recording.au_scale, 100);
  EXPECT_EQ(all->recording.face, -3);
  EXPECT_EQ(all->recording.confidence_min, 0.8);
  EXPECT_EQ(all->rate, 12.5);
  EXPECT_FALSE(read_source({{"au-scale", {"auto"}}})->recording.au_scale);
}

TEST(SourceOptions, WrongWordsAreNamedWithTheirRange) {
  const std::string fps =
      " is not a number of pictures a second above 0, at most 1000 (try --help)";
  EXPECT_EQ(source_message("fps", "0"), "--fps '0'" + fps);
  EXPECT_EQ(source_message("fps", "nan"), "--fps 'nan'" + fps);
  EXPECT_EQ(source_message("fps", "30fps"), "--fps '30fps'" + fps);
  EXPECT_EQ(source_message("au-scale", "7"),
            "--au-scale '7' is not one of 1, 5, 100 and auto (try --help)");
  EXPECT_EQ(source_message("face-id", "a"),
            "--face-id 'a' is neither a whole number nor all (try --help)");
  EXPECT_EQ(source_message("min-confidence", "50"),
            "--min-confidence '50' is not a number from 0 to 1 (try --help)");
  EXPECT_EQ(source_message("rate", "0.01"),
            "--rate '0.01' is not a number of keyframes a second from 0.1 to 1000 (try --help)");
}

/// A word that the option takes and that is not its default.
std::string word_for(const OptionRow& row) {
  if (row.value.kind == OptionValue::Kind::Flag) return "true";
  return row.option.name == "min-confidence" ? "0.9" : "1";
}

TEST(SourceOptions, AreNamedAsTheyAreTypedWhereNothingIsForThemToChange) {
  EXPECT_EQ(options_of_recordings({}), "");
  SourceOptions all;
  std::string names;
  const auto each = [&](const auto& rows_of) {
    for (const OptionRow& row : rows_of(all)) {
      SourceOptions one;
      const auto own = rows_of(one);
      EXPECT_FALSE(read_word(*find_row(own, row.option.name), word_for(row))) << row.option.name;
      // Stream files are resampled too, and a profile is written whatever was read.
      const bool for_others_too = row.option.name == "rate" || row.option.name == "save-profile";
      EXPECT_EQ(options_of_recordings(one), for_others_too ? "" : typed_name(row));
      if (for_others_too) continue;
      EXPECT_FALSE(read_word(row, word_for(row))) << row.option.name;
      names += (names.empty() ? "" : ", ") + typed_name(row);
    }
  };
  each([](SourceOptions& options) { return recording_rows(options); });
  each([](SourceOptions& options) { return signal_rows(options.signal); });
  EXPECT_EQ(options_of_recordings(all), names) << "in the order of --help";
}

TEST(CameraOptions, AreRead) {
  camera::CameraOptions options;
  const auto rows = camera_rows(options);
  EXPECT_TRUE(read_words(rows, {{"camera-size", {"1280x720"}}, {"camera-fps", {"25"}}}));
  EXPECT_EQ(options, (camera::CameraOptions{"/dev/video0", 1280, 720, 25}));
  for (const char* word : {"1280", "x720", "1280x", "0x0", "640x480x3", "99999x10"}) {
    EXPECT_FALSE(read_words(rows, {{"camera-size", {word}}})) << word;
  }
  EXPECT_FALSE(read_words(rows, {{"camera-fps", {"0"}}}));
}

}  // namespace
}  // namespace aucast::server
