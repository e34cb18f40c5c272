#include "server/streams/source_path.h"

#include <optional>

#include <gtest/gtest.h>

#include "server/streams/load_sources.h"

namespace aucast::server {
namespace {

TEST(SourcePath, ACameraIsALiveSourceOfThatName) {
  EXPECT_EQ(camera_device("camera"), "/dev/video0");
  EXPECT_EQ(camera_device("camera:/dev/video2"), "/dev/video2");
  EXPECT_EQ(camera_device("camera:"), std::nullopt);
  EXPECT_EQ(camera_device("./camera"), std::nullopt);
  EXPECT_EQ(camera_device("cameraman.txt"), std::nullopt);
  EXPECT_EQ(stream_name("camera:/dev/video2"), "camera");
  EXPECT_TRUE(is_live("camera", false));
  const auto checked = load_sources({"camera"});
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().kind, ErrorKind::Usage);
}

}  // namespace
}  // namespace aucast::server
