#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "common/result.h"

namespace aucast::server {

/// What a file that is recorded to begins and ends with.
struct RecordForm {
  std::string_view head;
  std::string_view tail;
};

/// A stream file: a keyframe's line is a piece.
inline constexpr RecordForm kStreamFileForm{"Beg_Stream\n", "End_Stream\n"};
/// Ogg: a page is a piece, and nothing stands around them.
inline constexpr RecordForm kPagesForm{};

/// A file that grows and is complete at every moment: what is added is written in one piece
/// together with a new tail, over the old tail. A program that is killed leaves a complete file; a
/// power cut can damage only what was not yet synced. A file that is not empty is never
/// overwritten.
class RecordFile {
 public:
  /// Failed, with the reason, when the file cannot be made, is not a regular file, or is not empty.
  [[nodiscard]] static Result<RecordFile> create(const std::filesystem::path& path,
                                                 const RecordForm& form = kStreamFileForm);
  RecordFile(RecordFile&& other) noexcept;
  RecordFile& operator=(RecordFile&&) = delete;
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  /// A file that was made here and that nothing was added to is removed.
  ~RecordFile();

  /// Adds a piece. If that fails, the file stays as it was.
  [[nodiscard]] Result<void> add(std::string_view piece);
  /// Syncs what was added to the disk.
  [[nodiscard]] Result<void> sync();

 private:
  RecordFile(std::filesystem::path path, const RecordForm& form, int descriptor, bool made);
  [[nodiscard]] Error failed() const;

  std::filesystem::path path_;
  RecordForm form_;
  int descriptor_ = -1;
  bool made_;             ///< there was none before
  std::int64_t end_ = 0;  ///< where the tail stands; 0: nothing was added yet
};

}  // namespace aucast::server
