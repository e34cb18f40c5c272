#pragma once

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "common/check.h"

namespace aucast::fuzz {

namespace fs = std::filesystem;

/// A folder for this process alone, removed with the object.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(fs::temp_directory_path() / ("aucast_fuzz_" + std::to_string(::getpid()) + name)) {
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  void write(const char* name, std::string_view text) const {
    std::FILE* file = std::fopen((path_ / name).c_str(), "wb");
    AUCAST_CHECK(file != nullptr);
    AUCAST_CHECK(std::fwrite(text.data(), 1, text.size(), file) == text.size());
    AUCAST_CHECK(std::fclose(file) == 0);
  }

 private:
  fs::path path_;
};

}  // namespace aucast::fuzz
