#include "client/app/assets.h"

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "tests/support/process.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

std::string message_of(std::string_view text) {
  const test::TempFolder folder;
  const auto loaded = load_expressions(folder.write("e.toml", text));
  EXPECT_FALSE(loaded.has_value());
  if (loaded) return "";
  EXPECT_EQ(loaded.error().kind, ErrorKind::BadData);
  return loaded.error().message;
}

TEST(LoadExpressions, ReadsNamesLabelsAndSets) {
  const test::TempFolder folder;
  const auto loaded = load_expressions(folder.write("e.toml", R"(
[[expression]]
name = "joy"
label = "Joy"
aus = "6,12:80"
source = "here"
[[expression]]
name = "plain"
aus = "0"
)"));
  ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
  ASSERT_EQ(loaded->size(), 2U);
  EXPECT_EQ((*loaded)[0].label, "Joy");
  EXPECT_EQ(protocol::format_au_set((*loaded)[0].aus), "6,12:80");
  EXPECT_EQ((*loaded)[1].label, "plain");
}

TEST(LoadExpressions, NamesThePlaceOfAMistake) {
  EXPECT_NE(message_of("[[expression]\n").find("e.toml:1:"), std::string::npos);
  EXPECT_NE(message_of("x = 1\n").find("no [[expression]]"), std::string::npos);
  EXPECT_NE(message_of("[[expression]]\naus = \"1\"\n").find("without name"), std::string::npos);
  EXPECT_NE(message_of("[[expression]]\nname = \"a\"\naus = \"1,x\"\n").find("expression 'a'"),
            std::string::npos);
  EXPECT_NE(message_of("[[expression]]\nname = \"a\"\naux = \"1\"\n").find("e.toml:3:1: unknown"),
            std::string::npos);
  EXPECT_NE(message_of("[[expression]]\nname = 3\n").find("is not a text"), std::string::npos);
}

TEST(ShippedAssets, LoadAndNameTheirExpressions) {
  FaceOptions options;
  options.data = test::program("data");
  const auto assets = load_assets(options);
  ASSERT_TRUE(assets.has_value()) << assets.error().message;
  EXPECT_EQ(protocol::format_au_set(*find_expression(**assets, "thesis-happiness")), "1,6,12,14");
  EXPECT_EQ(describe(**assets, *find_expression(**assets, "thesis-fear")), "Fear");
  EXPECT_EQ(describe(**assets, *protocol::parse_au_set("12:33")), "12:33");
  const auto typo = find_expression(**assets, "hapiness");
  ASSERT_FALSE(typo.has_value());
  EXPECT_NE(typo.error().message.find("did you mean happiness?"), std::string::npos);
}

TEST(ShippedAssets, AMissingFaceIsUnreadable) {
  FaceOptions options;
  options.data = test::program("data");
  options.face = "/no/such/face";
  const auto assets = load_assets(options);
  ASSERT_FALSE(assets.has_value());
  EXPECT_EQ(assets.error().kind, ErrorKind::Unreadable);
}

}  // namespace
}  // namespace aucast::app
