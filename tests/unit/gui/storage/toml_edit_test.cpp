#include "client/gui/storage/toml_edit.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

/// The file with another text for "name"; or what is wrong.
std::string renamed(std::string toml, const std::string& name) {
  const auto document = parse_toml(toml, "a.toml");
  EXPECT_TRUE(document);
  const auto put = put_text(toml, "a.toml", *document->find("name"), name);
  return put ? toml : put.error().message;
}

TEST(TomlEdit, ReplacesATextHoweverItIsQuoted) {
  for (const char* old :
       {"\"a\"", "'a'", "\"a \\\" b\"", "\"\"\"\na\n\"b\"\"\"\"", "'''a'''", "\"\""}) {
    const std::string text = "x = 1\nname = " + std::string(old) + "  # mine\ny = 2\n";
    EXPECT_EQ(renamed(text, "b\"c"), "x = 1\nname = \"b\\\"c\"  # mine\ny = 2\n");
  }
}

TEST(TomlEdit, LettersOfSeveralBytesMayStandBefore) {
  std::string toml = "a = { \"größe\" = 1, b = \"c\" }\n";
  const auto document = parse_toml(toml, "a.toml");
  ASSERT_TRUE(document);
  ASSERT_TRUE(put_text(toml, "a.toml", *document->find("a")->find("b"), "d"));
  EXPECT_EQ(toml, "a = { \"größe\" = 1, b = \"d\" }\n");
}

TEST(TomlEdit, WhatIsNoTextStays) {
  EXPECT_EQ(renamed("name = 7\n", "b"), "a.toml:1:8: this is not a text in quotes");
}

}  // namespace
}  // namespace aucast::gui
