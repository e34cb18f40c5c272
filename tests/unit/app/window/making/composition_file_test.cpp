#include "client/app/window/making/composition_file.h"

#include <gtest/gtest.h>

#include "common/files.h"
#include "protocol/stream_file.h"
#include "tests/support/composed.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

class CompositionFile : public testing::Test {
 protected:
  gui::Composer composer_;
};

TEST_F(CompositionFile, TheTextIsReadBackAsItWas) {
  composer_.set_au(1, 100, 100, false);
  composer_.set_au(12, 30, 0, false);
  composer_.add();
  composer_.set_aus({}, false);
  composer_.set_time(std::nullopt, false);
  composer_.add();
  const auto text = stream_text(composer_.keyframes());
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_EQ(*text, "Beg_Stream\n1,L12:30;500\n0\nEnd_Stream\n");
  EXPECT_FALSE(stream_text({}).has_value());
}

TEST_F(CompositionFile, ATitleIsBeforeTheStream) {
  test::compose(composer_, 1);
  const auto text = stream_text(composer_.keyframes(), "A talk");
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_EQ(*text, "# title: A talk\nBeg_Stream\n1;500\nEnd_Stream\n");
}

TEST_F(CompositionFile, EveryAuWithBothSidesIsServable) {
  for (int number = 1; number <= kAuNumberMax; ++number) {
    composer_.set_au(number, 33, 44, true);
  }
  composer_.add();
  const auto text = stream_text(composer_.keyframes());
  ASSERT_TRUE(text) << text.error().message;
  const auto read = protocol::parse_stream_file(*text, "all");
  ASSERT_TRUE(read);
  EXPECT_EQ(frame_from_terms(read->keyframes[0].terms), composer_.keyframes()[0]->aus);
}

TEST_F(CompositionFile, SavingKeepsTheVersionBefore) {
  const test::TempFolder folder;
  const auto file = folder.write("mine.txt", "# a note\nBeg_Stream\n1\nEnd_Stream\n");
  test::compose(composer_, 1);
  auto saved = save_stream(composer_.keyframes(), file);
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_NE(saved->find("mine.txt~"), std::string::npos);
  EXPECT_EQ(*read_file(file), "Beg_Stream\n1;500\nEnd_Stream\n");
  EXPECT_EQ(*read_file(file.string() + "~"), "# a note\nBeg_Stream\n1\nEnd_Stream\n");
  saved = save_stream(composer_.keyframes(), file);
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->find("~"), std::string::npos) << "nothing was replaced";
}

TEST_F(CompositionFile, AFolderThatIsNotThereIsSaid) {
  test::compose(composer_, 1);
  const auto saved = save_stream(composer_.keyframes(), "/no/such/folder/x.txt");
  ASSERT_FALSE(saved.has_value());
  EXPECT_EQ(saved.error().kind, ErrorKind::Failed);
}

}  // namespace
}  // namespace aucast::app
