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

}  // namespace
}  // namespace aucast::protocol
