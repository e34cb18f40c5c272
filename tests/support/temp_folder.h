#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace aucast::test {

/// A new folder, which is removed with the object.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file inside and returns its path.
  std::filesystem::path write(const std::string& name, std::string_view bytes) const;
  /// A file inside as text; empty when it is not there.
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

}  // namespace aucast::test
