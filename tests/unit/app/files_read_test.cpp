#include "client/app/files_read.h"

#include <gtest/gtest.h>

#include "tests/support/process.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

using Path = std::filesystem::path;

class CheckOutputs : public testing::Test {
 protected:
  CheckOutputs() {
    options_.face.data = test::program("data");
    for (const char* name : {"talk.txt", "talk.wav", "talk.vtt", "own.toml", "token", "mesh.ply",
                             "muscles.toml", "face/aus.toml", "face/picture.png"}) {
      folder_.write(name, "x");
    }
    folder_.write("face/face.toml", "mesh = '../mesh.ply'\nmuscles = '../muscles.toml'\n");
    options_.playback.file = at("talk.txt");
    options_.playback.security.token = at("token");
    options_.face.face = at("face").string();
    options_.face.rules = at("own.toml").string();
  }

  [[nodiscard]] Path at(const char* name) const { return folder_.path() / name; }

  test::TempFolder folder_;
  PlayerOptions options_;
};

TEST_F(CheckOutputs, RefuseEveryFileThatIsRead) {
  const Path data = test::program("data");
  for (const Path& read :
       {at("talk.txt"), at("talk.wav"), at("talk.vtt"), at("own.toml"), at("token"), at("mesh.ply"),
        at("muscles.toml"), at("face/aus.toml"), at("face/face.toml"), data / "expressions.toml",
        data / "rules" / "facs.toml"}) {
    options_.output.stats = read;
    const auto checked = check_outputs(options_);
    ASSERT_FALSE(checked.has_value()) << read;
    EXPECT_EQ(checked.error().kind, ErrorKind::Usage);
  }
  for (const Path& other : {at("new.json"), at("face/picture.png")}) {
    options_.output.stats = other;
    EXPECT_TRUE(check_outputs(options_).has_value()) << other;
  }
}

TEST_F(CheckOutputs, AreThoseOfAllOptions) {
  for (Path* output :
       {&options_.output.record, &options_.output.sheet, &options_.output.stats,
        &options_.output.onsets, &options_.sound.file, &options_.pose.png, &options_.pose.obj}) {
    *output = at("talk.txt");
    EXPECT_FALSE(check_outputs(options_).has_value());
    output->clear();
  }
  options_.command = Command::Export;
  options_.exported.files = {at("talk.txt"), at("talk.glb")};
  EXPECT_TRUE(check_outputs(options_).has_value());
  std::filesystem::create_symlink(at("talk.txt"), at("talk.glb"));
  EXPECT_FALSE(check_outputs(options_).has_value());
}

TEST_F(CheckOutputs, RefuseOneFileTwice) {
  options_.output.record = at("a");
  options_.output.stats = at("b");
  EXPECT_TRUE(check_outputs(options_).has_value());
  options_.output.stats = at("a");
  const auto checked = check_outputs(options_);
  ASSERT_FALSE(checked.has_value());
  EXPECT_EQ(checked.error().kind, ErrorKind::Usage);
}

TEST_F(CheckOutputs, RefuseThePicturesOfAFrameFolder) {
  options_.output.frames = at("frames");
  for (const char* other : {"frames/sheet.png", "frames/stats.json", "frame_000001.png"}) {
    options_.output.sheet = at(other);
    EXPECT_TRUE(check_outputs(options_).has_value()) << other;
  }
  options_.output.sheet = at("face/../frames/frame_000001.png");
  EXPECT_FALSE(check_outputs(options_).has_value());
}

}  // namespace
}  // namespace aucast::app
