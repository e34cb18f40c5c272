#include "client/app/window/playing/spoken_text.h"

#include <gtest/gtest.h>

#include <deque>
#include <filesystem>

#include "client/playback/seekable_playback.h"
#include "client/playback/source_playback.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::app {
namespace {

using namespace std::chrono_literals;

class CaptionedSource final : public playback::KeyframeSource {
 public:
  std::deque<playback::Caption> captions;

  [[nodiscard]] std::optional<playback::Keyframe> take() override { return std::nullopt; }
  [[nodiscard]] std::optional<playback::Caption> take_caption() override {
    if (captions.empty()) return std::nullopt;
    playback::Caption caption = captions.front();
    captions.pop_front();
    return caption;
  }
  [[nodiscard]] bool ready() const override { return true; }
  bool wait_until(Instant /*until*/) override { return true; }
  [[nodiscard]] playback::SourceStatus status() const override {
    playback::SourceStatus status;
    status.title = "A lecture";
    return status;
  }
  void stop() override {}
};

TEST(SpokenText, OfAServerIsWhatCameForThePlace) {
  auto source = std::make_unique<CaptionedSource>();
  source->captions = {{100ms, "Good day"}, {900ms, ""}};
  playback::SourcePlayback playback(std::move(source), {});
  SpokenText spoken;
  spoken.move_to(playback, 99ms);
  EXPECT_EQ(spoken.caption(), "");
  EXPECT_EQ(spoken.title(), "A lecture");
  spoken.move_to(playback, 100ms);
  EXPECT_EQ(spoken.caption(), "Good day");
  spoken.move_to(playback, 950ms);
  EXPECT_EQ(spoken.caption(), "");
}

TEST(SpokenText, OfAFileIsFoundAtAnyPlace) {
  const test::TempFolder folder;
  const auto stream =
      folder.write("talk.txt", "# title: A talk\nBeg_Stream\n12:50;4000\nEnd_Stream\n");
  folder.write("talk.vtt",
               "WEBVTT\n\n00:01.000 --> 00:02.000\nOne\n\n00:02.000 --> 00:03.000\nTwo\n");
  playback::SeekablePlayback playback({{AuFrame{}, 4000ms}}, 250ms);
  SpokenText spoken;
  ASSERT_TRUE(spoken.read_beside(stream));
  EXPECT_EQ(spoken.title(), "A talk");
  spoken.move_to(playback, 2500ms);
  EXPECT_EQ(spoken.caption(), "Two");
  spoken.move_to(playback, 1s);
  EXPECT_EQ(spoken.caption(), "One") << "sought back";
  spoken.move_to(playback, 3s);
  EXPECT_EQ(spoken.caption(), "");
  spoken.begin_again();
  EXPECT_EQ(spoken.title(), "");
}

TEST(SpokenText, AFolderHasNoCaptionsAndALinkToNowhereIsToldOf) {
  const test::TempFolder folder;
  const auto stream = folder.write("talk.txt", "Beg_Stream\n12:50;4000\nEnd_Stream\n");
  const auto captions = folder.path() / "talk.vtt";
  SpokenText spoken;
  std::filesystem::create_directory(captions);
  EXPECT_TRUE(spoken.read_beside(stream));
  std::filesystem::remove(captions);
  std::filesystem::create_symlink("nowhere", captions);
  EXPECT_EQ(spoken.read_beside(stream).error().kind, ErrorKind::Unreadable);
}

TEST(SpokenText, SaysWhatIsWrongWithCaptions) {
  const test::TempFolder folder;
  const auto stream = folder.write("talk.txt", "Beg_Stream\n12:50;4000\nEnd_Stream\n");
  SpokenText spoken;
  EXPECT_TRUE(spoken.read_beside(stream)) << "none is no error";
  folder.write("talk.vtt", "no captions");
  const auto read = spoken.read_beside(stream);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("talk.vtt"), std::string::npos);
}

}  // namespace
}  // namespace aucast::app
