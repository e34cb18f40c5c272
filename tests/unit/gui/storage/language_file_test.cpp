#include "client/gui/storage/language_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "client/face/face_folder.h"
#include "client/gui/storage/aus_file.h"
#include "client/gui/texts/texts.h"
#include "common/action_unit.h"
#include "common/toml_document.h"
#include "tests/support/temp_folder.h"

namespace aucast::gui {
namespace {

const std::filesystem::path kShipped = AUCAST_TEST_DATA;

std::string french_file() {
  std::ifstream file(kShipped / "languages" / "fr.toml");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// fr.toml with `to` in place of the first `from`, and the number of that line.
struct Changed {
  Result<LoadedLanguage> loaded;
  std::string line;
};

Changed changed(const std::string& from, const std::string& to) {
  std::string text = french_file();
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at == std::string::npos) return {Error{}, {}};
  text.replace(at, from.size(), to);
  const test::TempFolder folder;
  folder.write("fr.toml", text);
  const auto lines = std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
  return {load_language(folder.path() / "fr.toml"), std::to_string(1 + lines)};
}

/// Why fr.toml is refused when `from` stands there as `to`.
std::string refusal_of(const std::string& from, const std::string& to) {
  const Changed file = changed(from, to);
  EXPECT_FALSE(file.loaded);
  if (file.loaded) return {};
  EXPECT_EQ(file.loaded.error().kind, ErrorKind::BadData);
  return file.loaded.error().message;
}

/// What is said of the only text that is left out when `from` stands there as `to`; "there: "
/// before it when it has the place of the change.
std::string left_out_of(const std::string& from, const std::string& to) {
  const Changed file = changed(from, to);
  EXPECT_TRUE(file.loaded);
  if (!file.loaded || file.loaded->left_out.size() != 1) return {};
  EXPECT_EQ(file.loaded->language.texts[TextKey("button.save").row()], "Enregistrer");
  const std::string& said = file.loaded->left_out.front();
  EXPECT_NE(said.find("fr.toml:"), std::string::npos) << said;
  return said.find("fr.toml:" + file.line + ":") == std::string::npos ? said : "there: " + said;
}

TEST(LanguageFile, FrenchIsWhole) {
  const auto loaded = load_language(kShipped / "languages" / "fr.toml");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->left_out, std::vector<std::string>());
  const Language& french = loaded->language;
  EXPECT_EQ(french.name, "Français");
  for (int number = 0; number <= kAuNumberMax; ++number) {
    EXPECT_EQ(french.au_names.contains(number), facs_name(number).has_value()) << number;
  }
  const auto looks = read_toml(kShipped / "action_units.toml");
  ASSERT_TRUE(looks);
  for (const auto& entry : looks->find("looks")->entries) {
    EXPECT_TRUE(french.au_looks.contains(std::stoi(entry.key))) << entry.key;
  }
  const auto expressions = read_toml(kShipped / "expressions.toml");
  ASSERT_TRUE(expressions);
  for (const TomlValue& one : expressions->find("expression")->items) {
    const TomlValue* label = one.find("label");
    if (label == nullptr) continue;
    EXPECT_TRUE(french.words.contains(label->text)) << label->text;
  }
}

TEST(LanguageFile, FrenchHasTheNamesOfWhatMovesTheFace) {
  const auto french = load_language(kShipped / "languages" / "fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  const auto face = face::load_face(kShipped / "faces" / "default", kShipped);
  ASSERT_TRUE(face) << face.error().message;
  for (const face::Channel& channel : face->channels) {
    std::string name(split_side(channel.name).base);
    if (!face->channel_index(sided_name(Side::Left, name))) name = channel.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    EXPECT_TRUE(french->language.words.contains(name)) << name;
  }
}

TEST(LanguageFile, AMuscleOfOneSideHasNoCommaThatLooksLikeTheEndOfIt) {
  auto french = load_language(kShipped / "languages" / "fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  use_language(std::move(french->language));
  const std::string drive = drive_in_words({{"left_smile", 0.6F}, {"right_bite", 0.3F}});
  use_english();
  EXPECT_EQ(std::count(drive.begin(), drive.end(), ','), 1) << drive;
  EXPECT_NE(drive.find("smile (à gauche) 0.6"), std::string::npos) << drive;
}

TEST(LanguageFile, AMissingTextIsEnglishAndSaid) {
  const std::string said = left_out_of("\nsave_as = ", "\n# save_as = ");
  EXPECT_NE(said.find("'save_as' is missing"), std::string::npos) << said;
  const Changed file = changed("\nsave_as = ", "\n# save_as = ");
  ASSERT_TRUE(file.loaded);
  const std::size_t row = TextKey("button.save_as").row();
  EXPECT_EQ(file.loaded->language.texts[row], kEnglish[row].text);
}

TEST(LanguageFile, AnUnknownTextIsLeftOutAndSaidWithItsPlace) {
  const std::string said = left_out_of("\nplay = ", "\nnothing = \"rien\"\nplay = ");
  EXPECT_NE(said.find("unknown key 'nothing'"), std::string::npos) << said;
}

TEST(LanguageFile, ATextThatIsNoneIsLeftOut) {
  const std::string said = left_out_of("open = \"Ouvrir\"", "open = 5");
  EXPECT_TRUE(said.starts_with("there: ")) << said;
  EXPECT_NE(said.find("open must be a text"), std::string::npos) << said;
}

TEST(LanguageFile, AMissingSectionIsRefused) {
  const std::string said = refusal_of("[leave]\n", "[left]\n");
  EXPECT_NE(said.find("[leave]"), std::string::npos) << said;
}

TEST(LanguageFile, OtherPlacesToFillInAreLeftOut) {
  const std::string said = left_out_of("{drawn} images sur", "{drown} images sur");
  EXPECT_TRUE(said.starts_with("there: ")) << said;
  EXPECT_NE(said.find("{drown}"), std::string::npos) << said;
  EXPECT_NE(said.find("{drawn}"), std::string::npos) << said;
  EXPECT_NE(left_out_of("{drawn} images sur", "{drawn images sur"), "");
}

TEST(LanguageFile, AFileThatIsNoTomlIsRefused) {
  EXPECT_NE(refusal_of("[tab]", "[tab"), "");
}

}  // namespace
}  // namespace aucast::gui
