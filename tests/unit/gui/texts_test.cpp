#include "client/gui/texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "client/gui/view_text.h"
#include "common/action_unit.h"
#include "common/toml_document.h"
#include "tests/support/temp_folder.h"

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
    use_language(*std::move(french));
  }
};

std::string french_file() {
  std::ifstream file(kData / "languages" / "fr.toml");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What is said about fr.toml when `from` stands there as `to`.
std::string complaint_about(const std::string& from, const std::string& to) {
  std::string text = french_file();
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at == std::string::npos) return {};
  text.replace(at, from.size(), to);
  const test::TempFolder folder;
  folder.write("fr.toml", text);
  const auto loaded = load_language(folder.path() / "fr.toml");
  EXPECT_FALSE(loaded);
  if (loaded) return {};
  const std::string line =
      ":" +
      std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
  const std::string& message = loaded.error().message;
  EXPECT_EQ(loaded.error().kind, ErrorKind::BadData);
  EXPECT_NE(message.find("fr.toml:"), std::string::npos) << message;
  return message.find("fr.toml" + line + ":") == std::string::npos ? message : "there: " + message;
}

TEST_F(Texts, EveryKeyStandsOnceInTheTable) {
  std::set<std::string_view> keys;
  for (const EnglishText& one : kEnglish) {
    EXPECT_TRUE(keys.insert(one.key).second) << one.key;
    EXPECT_NE(*one.text, 0) << one.key;
  }
}

TEST_F(Texts, FrenchIsWhole) {
  const auto french = load_language(kData / "languages" / "fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  EXPECT_EQ(french->name, "Français");
  for (int number = 0; number <= kAuNumberMax; ++number) {
    EXPECT_EQ(french->au_names.contains(number), facs_name(number).has_value()) << number;
  }
  const auto looks = read_toml(kData / "action_units.toml");
  ASSERT_TRUE(looks);
  for (const auto& entry : looks->find("looks")->entries) {
    EXPECT_TRUE(french->au_looks.contains(std::stoi(entry.key))) << entry.key;
  }
  const auto expressions = read_toml(kData / "expressions.toml");
  ASSERT_TRUE(expressions);
  for (const TomlValue& one : expressions->find("expression")->items) {
    const TomlValue* label = one.find("label");
    if (label == nullptr) continue;
    EXPECT_TRUE(french->words.contains(label->text)) << label->text;
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

TEST_F(Texts, AMissingTextIsSaidWithItsPlace) {
  const std::string said = complaint_about("\nsave_as = ", "\n# save_as = ");
  EXPECT_NE(said.find("save_as"), std::string::npos) << said;
}

TEST_F(Texts, ATextTooManyIsSaidWithItsPlace) {
  const std::string said = complaint_about("[tab]\n", "[tab]\nnothing = \"rien\"\n");
  EXPECT_NE(said.find("'nothing'"), std::string::npos) << said;
}

TEST_F(Texts, AMissingSectionIsSaid) {
  const std::string said = complaint_about("[leave]\n", "[left]\n");
  EXPECT_NE(said.find("[leave]"), std::string::npos) << said;
}

TEST_F(Texts, OtherPlacesToFillInAreSaid) {
  const std::string said = complaint_about("{drawn} images sur", "{drown} images sur");
  EXPECT_TRUE(said.starts_with("there: ")) << said;
  EXPECT_NE(said.find("{drown}"), std::string::npos) << said;
  EXPECT_NE(said.find("{drawn}"), std::string::npos) << said;
  complaint_about("{drawn} images sur", "{drawn images sur");
}

TEST_F(Texts, WarningsAboutATableNameTheFieldsThatTheDialogHas) {
  for (const bool in_french : {false, true}) {
    if (in_french) use_french();
    const std::string fps = tr("file.fps");
    EXPECT_NE(tr("made.needs_fps", "x", "30").find(fps), std::string::npos);
    EXPECT_NE(tr("made.hasty_clock", "1000").find(fps), std::string::npos);
    EXPECT_NE(tr("made.still_clock", "2 rows", "30").find(fps), std::string::npos);
    const std::string quiet = tr("file.quiet");
    EXPECT_NE(tr("made.unquiet", "AU7 100 %").find(quiet), std::string::npos);
    EXPECT_NE(tr("made.unquiet_span", "AU7 100 %", "2").find(quiet), std::string::npos);
  }
}

TEST_F(Texts, AFileThatIsNoTomlIsSaid) {
  complaint_about("[tab]", "[tab");
}

}  // namespace
}  // namespace aucast::gui
