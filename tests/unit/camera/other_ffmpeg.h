#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "common/files.h"
#include "tests/support/temp_folder.h"

namespace aucast::camera {

/// A path that exists and is no regular file: the camera whose pictures an OtherFfmpeg makes.
inline constexpr const char* kDevice = "/dev/null";

/// A program `ffmpeg` of our own, first in $PATH while this object lives.
class OtherFfmpeg {
 public:
  explicit OtherFfmpeg(const std::string& script) : path_(std::getenv("PATH")) {
    const auto file = folder_.path() / "ffmpeg";
    EXPECT_TRUE(write_file_atomically(file, "#!/bin/sh\n" + script).has_value());
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    ::setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  ~OtherFfmpeg() { ::setenv("PATH", path_.c_str(), 1); }
  OtherFfmpeg(const OtherFfmpeg&) = delete;
  OtherFfmpeg& operator=(const OtherFfmpeg&) = delete;

  [[nodiscard]] std::filesystem::path file(const std::string& name, const std::string& text) {
    return folder_.write(name, text);
  }

 private:
  test::TempFolder folder_;
  std::string path_;
};

}  // namespace aucast::camera
