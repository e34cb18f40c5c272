#include "client/gui/texts/texts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "client/gui/model/view_text.h"
#include "client/gui/storage/language_file.h"

namespace aucast::gui {
namespace {

const std::filesystem::path kData = AUCAST_TEST_DATA;

/// French, and English again afterwards.
class Texts : public testing::Test {
 protected:
  void TearDown() override { use_english(); }
  static void use_french() {
    auto french = load_language(kData / "languages" / "fr.toml");
    ASSERT_TRUE(french) << french.error().message;
    use_language(std::move(french->language));
  }
};

TEST_F(Texts, EveryKeyStandsOnceInTheTable) {
  std::set<std::string_view> keys;
  for (const EnglishText& one : kEnglish) {
    EXPECT_TRUE(keys.insert(one.key).second) << one.key;
    EXPECT_NE(*one.text, 0) << one.key;
  }
}

TEST_F(Texts, AreOfTheLanguageInUse) {
  EXPECT_STREQ(tr("button.save"), "Save");
  EXPECT_EQ(tr("gallery.progress", 3, 10), "3 of 10 pictures");
  EXPECT_EQ(au_name(12), "Lip Corner Puller");
  const char* const before = tr("button.save");
  use_french();
  EXPECT_STREQ(tr("button.save"), "Enregistrer");
  EXPECT_EQ(tr("gallery.progress", 3, 10), "3 images sur 10");
  EXPECT_EQ(au_name(12), "Étireur du coin des lèvres");
  EXPECT_EQ(au_name(12, "Lip Corner Puller"), "Étireur du coin des lèvres");
  EXPECT_EQ(au_name(12, "My smile"), "My smile") << "who made it calls it so";
  EXPECT_EQ(data_word("Happiness"), "Joie");
  EXPECT_EQ(data_word("Smirk"), "Smirk");
  EXPECT_EQ(keyframes_text(1), "1 image clé");
  EXPECT_EQ(state_name(playback::PlaybackState::Paused), "en pause");
  EXPECT_STREQ(before, "Save") << "what was handed out stays";
  use_english();
  EXPECT_STREQ(tr("button.save"), "Save");
}

TEST_F(Texts, ALanguageIsKeptOnceHoweverOftenItIsChosen) {
  use_french();
  const char* const before = tr("button.save");
  use_english();
  use_french();
  EXPECT_EQ(static_cast<const void*>(tr("button.save")), static_cast<const void*>(before));
}

TEST_F(Texts, AValueWithBracesIsNotFilledAgain) {
  EXPECT_EQ(tr("file.there", "{file}{}"), "{file}{} is there already.");
}

TEST_F(Texts, WarningsAboutATableNameTheFieldsThatTheDialogHas) {
  for (const bool in_french : {false, true}) {
    if (in_french) use_french();
    const std::string fps = tr("file.fps");
    EXPECT_NE(tr("made.needs_fps", "x", "30").find(fps), std::string::npos);
    EXPECT_NE(tr("made.hasty_clock", "1000").find(fps), std::string::npos);
    EXPECT_NE(tr("made.still_clock", "2 rows", "30").find(fps), std::string::npos);
    const std::string neutral = tr("file.neutral");
    EXPECT_NE(tr("made.not_neutral", "AU7 100 %").find(neutral), std::string::npos);
    EXPECT_NE(tr("made.not_neutral_span", "AU7 100 %", "2").find(neutral), std::string::npos);
  }
}

}  // namespace
}  // namespace aucast::gui
