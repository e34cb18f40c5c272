#include "client/app/window/settings/language_choice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "client/app/assets.h"
#include "client/gui/texts/texts.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

TEST(LanguageChoice, TheFirstLocaleThatIsSetCounts) {
  EXPECT_EQ(language_of_locale(nullptr, nullptr, nullptr), "en");
  EXPECT_EQ(language_of_locale(nullptr, nullptr, "fr_CA.UTF-8"), "fr");
  EXPECT_EQ(language_of_locale("", "fr_FR", "de_DE.UTF-8"), "fr");
  EXPECT_EQ(language_of_locale("C.UTF-8", "fr_FR", "fr_FR"), "en");
  EXPECT_EQ(language_of_locale("POSIX", nullptr, nullptr), "en");
  EXPECT_EQ(language_of_locale(nullptr, "de", nullptr), "de");
}

TEST(LanguageChoice, ShippedLanguagesAreThereAndCanBeChosen) {
  const auto assets = load_assets({});
  ASSERT_TRUE(assets) << assets.error().message;
  const std::filesystem::path data = (*assets)->data_folder;
  const auto languages = languages_in(data);
  const auto named = [&](const gui::LanguageEntry& wanted) {
    return std::find(languages.begin(), languages.end(), wanted) != languages.end();
  };
  EXPECT_TRUE(named({"en", "English"}));
  EXPECT_TRUE(named({"fr", "Français"}));
  ASSERT_TRUE(choose_language(data, "fr"));
  EXPECT_STREQ(gui::tr("button.save"), "Enregistrer");
  const auto unknown = choose_language(data, "xx");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().kind, ErrorKind::Usage);
  EXPECT_NE(unknown.error().message.find("en, fr"), std::string::npos);
  EXPECT_FALSE(choose_language(data, "../languages/fr"));
  EXPECT_STREQ(gui::tr("button.save"), "Enregistrer") << "it stays what it was";
  ASSERT_TRUE(choose_language(data, "en"));
  EXPECT_STREQ(gui::tr("button.save"), "Save");
}

TEST(LanguageChoice, ABrokenFileIsNoLanguageAndSaysWhere) {
  const test::TempFolder folder;
  std::filesystem::create_directory(folder.path() / "languages");
  folder.write("languages/de.toml", "name = \"Deutsch\"\n");
  EXPECT_EQ(languages_in(folder.path()).size(), 1U);
  const auto chosen = choose_language(folder.path(), "de");
  ASSERT_FALSE(chosen);
  EXPECT_EQ(chosen.error().kind, ErrorKind::BadData);
  EXPECT_NE(chosen.error().message.find("de.toml:"), std::string::npos);
}

}  // namespace
}  // namespace aucast::app
