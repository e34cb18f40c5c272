#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/temp_folder.h"

namespace aucast::test {

/// While this object lives, a shell script is called in the place of ffmpeg.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const std::string& script) : before_(std::getenv("PATH")) {
    const auto file = folder_.write("ffmpeg", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    ::setenv("PATH", (folder_.path().string() + ":" + before_).c_str(), 1);
  }
  ~FakeFfmpeg() { ::setenv("PATH", before_.c_str(), 1); }
  FakeFfmpeg(const FakeFfmpeg&) = delete;
  FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;

 private:
  TempFolder folder_;
  std::string before_;
};

}  // namespace aucast::test
