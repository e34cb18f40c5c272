#include "protocol/token_file.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "tests/support/temp_folder.h"

namespace aucast::protocol {
namespace {

TEST(TokenFile, ReadsOneWordAndNeverQuotesIt) {
  const test::TempFolder folder;
  const auto read = [&folder](const std::string& text) {
    return read_token_file(folder.write("token", text));
  };
  EXPECT_EQ(read("\n  word-1=2 \r\n")->word, "word-1=2");
  EXPECT_EQ(read(std::string(kTokenBytesMax, 'x'))->word.size(), kTokenBytesMax);
  for (const std::string& wrong :
       {std::string(), std::string(" \n"), std::string("two words"), std::string("bra{ce"),
        std::string("caf\xc3\xa9"), std::string(kTokenBytesMax + 1, 'x')}) {
    const auto token = read(wrong);
    ASSERT_FALSE(token) << wrong;
    EXPECT_EQ(token.error().kind, ErrorKind::BadData);
    EXPECT_EQ(token.error().message.find("two"), std::string::npos);
  }
  EXPECT_EQ(read_token_file("/nowhere").error().kind, ErrorKind::Unreadable);
}

TEST(TokenFile, ThatEverybodyCanUseIsSaid) {
  namespace fs = std::filesystem;
  const test::TempFolder folder;
  const auto path = folder.write("token", "word");
  for (const auto& [mode, is_said] :
       {std::pair{0600U, false}, {0640U, false}, {0644U, true}, {0602U, true}}) {
    fs::permissions(path, static_cast<fs::perms>(mode));
    const auto token = read_token_file(path);
    ASSERT_TRUE(token);
    EXPECT_EQ(!token->warning.empty(), is_said) << std::oct << mode;
    EXPECT_EQ(token->warning.find("word"), std::string::npos);
  }
}

}  // namespace
}  // namespace aucast::protocol
