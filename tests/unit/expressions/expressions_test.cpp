#include "common/expressions/expressions.h"

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "tests/support/temp_folder.h"

namespace aucast {
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
  EXPECT_NE(message_of("[[expression]]\naus = \"1\"\n").find("'name' is missing"),
            std::string::npos);
  EXPECT_NE(message_of("[[expression]]\nname = \"a\"\naus = \"1,x\"\n")
                .find("e.toml:3:7: aus of expression 'a'"),
            std::string::npos);
  EXPECT_NE(message_of("[[expression]]\nname = \"a\"\naux = \"1\"\n").find("e.toml:3:1: unknown"),
            std::string::npos);
  EXPECT_NE(message_of("[[expression]]\nname = 3\n").find("name must be a text"),
            std::string::npos);
}

TEST(LoadExpressions, ReadsMusclesWithTheirSidesAndSpellings) {
  const test::TempFolder folder;
  const auto loaded = load_expressions(folder.write("e.toml", R"(
[[expression]]
name = "pull"
muscles = { zygomaticus_major = [1.0, 0.5] }
[muscle_names]
zygomaticus_major = ["Zygomatic_Major"]
)"));
  ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
  const Expression& pull = loaded->front();
  ASSERT_EQ(pull.muscles.size(), 1U);
  EXPECT_EQ(pull.muscles[0].left, 1.0F);
  EXPECT_EQ(pull.muscles[0].right, 0.5F);
  EXPECT_EQ(pull.muscles[0].spellings, (std::vector<std::string>{"Zygomatic_Major"}));
  EXPECT_EQ(pull.aus, AuFrame{});
}

TEST(LoadExpressions, RefusesBadMusclesAndNames) {
  const std::string begin = "[[expression]]\nname = \"a\"\n";
  EXPECT_NE(message_of(begin).find("neither aus nor muscles"), std::string::npos);
  EXPECT_NE(message_of(begin + "muscles = 1\n").find("muscles must be a table"), std::string::npos);
  for (const char* value : {"1.0", "[1.0]", "[1.0, -1.0]", "[1.0, \"x\"]", "[nan, 1.0]"}) {
    EXPECT_NE(message_of(begin + "muscles = { m = " + value + " }\n").find(": m "),
              std::string::npos)
        << value;
  }
  EXPECT_NE(message_of(begin + "aus = \"1\"\n[muscle_names]\nm = 1\n").find("m must be a list"),
            std::string::npos);
  EXPECT_NE(message_of(begin + "aus = \"1\"\n" + begin + "aus = \"2\"\n").find("a second"),
            std::string::npos);
  EXPECT_NE(
      message_of("[[expression]]\nname = \"a/b\"\naus = \"1\"\n").find("must be 1 to 64 letters"),
      std::string::npos);
}

}  // namespace
}  // namespace aucast
