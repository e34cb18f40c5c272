#pragma once

#include <filesystem>
#include <system_error>
#include <utility>

#include "common/files.h"
#include "common/result.h"

namespace aucast {

/// A file that is not complete yet, beside the one that it will be; see create_temporary_beside().
/// It is removed with this object, unless replace() has given it its name.
class TemporaryFile {
 public:
  [[nodiscard]] static Result<TemporaryFile> beside(const std::filesystem::path& path) {
    auto temporary = create_temporary_beside(path);
    if (!temporary) return temporary.error();
    return TemporaryFile(std::move(*temporary));
  }
  TemporaryFile() = default;
  ~TemporaryFile() { remove(); }
  TemporaryFile(TemporaryFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  TemporaryFile& operator=(TemporaryFile&& other) noexcept {
    if (this == &other) return *this;
    remove();
    path_ = std::exchange(other.path_, {});
    return *this;
  }

  /// Empty: there is none any more.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// See replace_file(): there is no temporary file any more, whether or not it succeeds.
  [[nodiscard]] Result<void> replace(const std::filesystem::path& path) {
    return replace_file(std::exchange(path_, {}), path);
  }
  void remove() {
    if (path_.empty()) return;
    std::error_code ignored;
    std::filesystem::remove(std::exchange(path_, {}), ignored);
  }

 private:
  explicit TemporaryFile(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
};

}  // namespace aucast
