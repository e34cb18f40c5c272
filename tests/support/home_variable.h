#pragma once

#include <cstdlib>
#include <string>

#include "tests/support/temp_folder.h"

namespace aucast::test {

/// A folder of its own that is HOME for as long as it lives.
class HomeVariable {
 public:
  HomeVariable() { ::setenv("HOME", folder_.path().c_str(), 1); }
  ~HomeVariable() {
    if (set_) {
      ::setenv("HOME", before_.c_str(), 1);
    } else {
      ::unsetenv("HOME");
    }
  }
  HomeVariable(const HomeVariable&) = delete;
  HomeVariable& operator=(const HomeVariable&) = delete;

  [[nodiscard]] const TempFolder& folder() const { return folder_; }
  /// The path of what is called `name` there.
  [[nodiscard]] std::string in(const std::string& name) const {
    return (folder_.path() / name).string();
  }

 private:
  const TempFolder folder_;
  const bool set_ = std::getenv("HOME") != nullptr;
  const std::string before_ = set_ ? std::getenv("HOME") : "";
};

}  // namespace aucast::test
