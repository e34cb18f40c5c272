#pragma once

#include <string>

#include <gtest/gtest.h>

#include "tests/support/process.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {

/// Everything that `cmake --install` installs, in a folder of its own.
class Installed : public ::testing::Test {
 protected:
  void SetUp() override {
    const Finished installed =
        run({"cmake", "--install", AUCAST_BUILD_FOLDER, "--prefix", folder_.path().string()});
    ASSERT_EQ(installed.exit_code, 0) << installed.err;
  }
  [[nodiscard]] std::string at(const std::string& path) const {
    return (folder_.path() / path).string();
  }

  TempFolder folder_;
};

}  // namespace aucast::test
