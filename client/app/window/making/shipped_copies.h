#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

namespace aucast::app {

/// Tells which folders hold the shipped face of their name: where the programs are built, data/ is
/// there twice, as it is written and as a copy beside them. Meshes are large, so files are read
/// only if all have the same sizes, and again only once one of them has changed.
/// Thread: that of its owner.
class ShippedCopies {
 public:
  /// `shipped`: the folder with the shipped faces.
  explicit ShippedCopies(std::filesystem::path shipped) : shipped_(std::move(shipped)) {}

  [[nodiscard]] bool contain(const std::filesystem::path& face);

 private:
  struct File {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type written;
    friend bool operator==(const File&, const File&) = default;
  };
  /// By their paths within a folder; empty: the folder cannot be read.
  using Files = std::map<std::filesystem::path, File>;
  struct Compared {
    Files here;
    Files shipped;
    bool same = false;
  };

  [[nodiscard]] static Files files_in(const std::filesystem::path& folder);
  [[nodiscard]] static bool same_files(const std::filesystem::path& here,
                                       const std::filesystem::path& there, const Compared& files);
  [[nodiscard]] bool same(const std::filesystem::path& folder);

  std::filesystem::path shipped_;
  std::map<std::filesystem::path, Compared> compared_;
};

}  // namespace aucast::app
