#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "common/result.h"

namespace aucast::server {

/// A stream file that grows and is whole whenever somebody looks: what is added is written in one
/// piece with the End_Stream behind it, over the End_Stream before. A program that is killed leaves
/// a whole file; what a power cut can tear is what was not yet synced. A file that holds anything
/// is never written over.
class RecordFile {
 public:
  /// Failed, with the reason, when the file cannot be made, is no plain file, or holds anything.
  [[nodiscard]] static Result<RecordFile> create(const std::filesystem::path& path);
  RecordFile(RecordFile&& other) noexcept;
  RecordFile& operator=(RecordFile&&) = delete;
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  /// A file that nothing was added to is no stream, and is removed.
  ~RecordFile();

  /// A keyframe's line with its end. When it fails, the file stays what it was.
  [[nodiscard]] Result<void> add(std::string_view line);
  /// Brings what was added to the disk.
  [[nodiscard]] Result<void> sync();

 private:
  RecordFile(std::filesystem::path path, int descriptor);
  [[nodiscard]] Error failed() const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::int64_t end_ = 0;  ///< where End_Stream stands; 0: nothing was added yet
};

}  // namespace aucast::server
