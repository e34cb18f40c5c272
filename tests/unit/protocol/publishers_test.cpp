#include "protocol/publishers.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "protocol/limits.h"
#include "tests/support/temp_folder.h"

namespace aucast::protocol {
namespace {

using Verdict = Publishers::Verdict;

class PublisherFileTest : public testing::Test {
 protected:
  Result<PublisherFile> read(const std::string& text) {
    return read_publisher_file(folder_.write("publishers", text));
  }
  test::TempFolder folder_;
};

TEST_F(PublisherFileTest, HasAPublisherALine) {
  const auto file = read("# lecturers\n\n word-1  talk seminar\r\nword-2\n");
  ASSERT_TRUE(file) << file.error().message;
  const Publishers& publishers = file->publishers;
  EXPECT_EQ(publishers.verdict("word-1", "talk"), Verdict::Welcome);
  EXPECT_EQ(publishers.verdict("word-1", "seminar"), Verdict::Welcome);
  EXPECT_EQ(publishers.verdict("word-1", "other"), Verdict::OtherNames);
  EXPECT_EQ(publishers.verdict("word-2", "other"), Verdict::Welcome) << "for any name";
  EXPECT_EQ(publishers.verdict("word-3", "talk"), Verdict::Unknown);
  EXPECT_EQ(publishers.verdict("word", "talk"), Verdict::Unknown);
  EXPECT_EQ(publishers.verdict("#", "lecturers"), Verdict::Unknown);
}

TEST_F(PublisherFileTest, SaysWhichLineIsWrongAndQuotesNoToken) {
  for (const auto& [text, place] :
       {std::pair<std::string, std::string>{"ok\nsecret{ talk\n", ":2: a token is printable"},
        {"secret talk/1\n", ":1: 'talk/1' is no stream's name"},
        {"secret talk\nsecret\n", ":2: this token stands on a line before"},
        {std::string(kTokenBytesMax + 1, 'x'), ":1: the token is longer"},
        {"Beg_Stream\n6,12\nEnd_Stream\n", ":1: this is a stream file"},
        {"# nobody\n", ": there is no token"},
        {"", ": there is no token"}}) {
    const auto file = read(text);
    ASSERT_FALSE(file) << text;
    EXPECT_EQ(file.error().kind, ErrorKind::BadData);
    EXPECT_NE(file.error().message.find(place), std::string::npos) << file.error().message;
    EXPECT_EQ(file.error().message.find("secret"), std::string::npos) << file.error().message;
  }
  EXPECT_EQ(read_publisher_file("/nowhere").error().kind, ErrorKind::Unreadable);
  EXPECT_FALSE(read(std::string(kPublisherFileBytesMax + 1, '\n')));
}

TEST_F(PublisherFileTest, ThatEverybodyCanReadIsSaid) {
  const auto path = folder_.write("publishers", "word\n");
  std::filesystem::permissions(path, static_cast<std::filesystem::perms>(0644));
  EXPECT_NE(read_publisher_file(path)->warning, "");
  std::filesystem::permissions(path, static_cast<std::filesystem::perms>(0600));
  EXPECT_EQ(read_publisher_file(path)->warning, "");
}

}  // namespace
}  // namespace aucast::protocol
