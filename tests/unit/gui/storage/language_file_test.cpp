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

TEST(LanguageFile, FrenchIsWhole) {
  const auto french = load_language(kShipped / "languages" / "fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  EXPECT_EQ(french->name, "Français");
  for (int number = 0; number <= kAuNumberMax; ++number) {
    EXPECT_EQ(french->au_names.contains(number), facs_name(number).has_value()) << number;
  }
  const auto looks = read_toml(kShipped / "action_units.toml");
  ASSERT_TRUE(looks);
  for (const auto& entry : looks->find("looks")->entries) {
    EXPECT_TRUE(french->au_looks.contains(std::stoi(entry.key))) << entry.key;
  }
  const auto expressions = read_toml(kShipped / "expressions.toml");
  ASSERT_TRUE(expressions);
  for (const TomlValue& one : expressions->find("expression")->items) {
    const TomlValue* label = one.find("label");
    if (label == nullptr) continue;
    EXPECT_TRUE(french->words.contains(label->text)) << label->text;
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
    EXPECT_TRUE(french->words.contains(name)) << name;
  }
}

TEST(LanguageFile, AMuscleOfOneSideHasNoCommaThatLooksLikeTheEndOfIt) {
  auto french = load_language(kShipped / "languages" / "fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  use_language(*std::move(french));
  const std::string drive = drive_in_words({{"left_smile", 0.6F}, {"right_bite", 0.3F}});
  use_english();
  EXPECT_EQ(std::count(drive.begin(), drive.end(), ','), 1) << drive;
  EXPECT_NE(drive.find("smile (à gauche) 0.6"), std::string::npos) << drive;
}

TEST(LanguageFile, AMissingTextIsSaidWithItsPlace) {
  const std::string said = complaint_about("\nsave_as = ", "\n# save_as = ");
  EXPECT_NE(said.find("save_as"), std::string::npos) << said;
}

TEST(LanguageFile, ATextTooManyIsSaidWithItsPlace) {
  const std::string said = complaint_about("[tab]\n", "[tab]\nnothing = \"rien\"\n");
  EXPECT_NE(said.find("'nothing'"), std::string::npos) << said;
}

TEST(LanguageFile, AMissingSectionIsSaid) {
  const std::string said = complaint_about("[leave]\n", "[left]\n");
  EXPECT_NE(said.find("[leave]"), std::string::npos) << said;
}

TEST(LanguageFile, OtherPlacesToFillInAreSaid) {
  const std::string said = complaint_about("{drawn} images sur", "{drown} images sur");
  EXPECT_TRUE(said.starts_with("there: ")) << said;
  EXPECT_NE(said.find("{drown}"), std::string::npos) << said;
  EXPECT_NE(said.find("{drawn}"), std::string::npos) << said;
  complaint_about("{drawn} images sur", "{drawn images sur");
}

TEST(LanguageFile, AFileThatIsNoTomlIsSaid) {
  complaint_about("[tab]", "[tab");
}

}  // namespace
}  // namespace aucast::gui
