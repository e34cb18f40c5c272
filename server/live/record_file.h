#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "common/descriptor.h"
#include "common/result.h"

namespace aucast::server {

/// The bytes with which a recorded file begins and ends.
struct RecordForm {
  std::string_view head;
  std::string_view tail;
};

/// A stream file; each piece is a keyframe's line.
inline constexpr RecordForm kStreamFileForm{"Beg_Stream\n", "End_Stream\n"};
/// An Ogg file; each piece is a page, and there is no head or tail.
inline constexpr RecordForm kPagesForm{};

/// A file that grows and is always complete: what is added is written together with a new tail, in
/// one call, over the old tail. A program that is killed leaves a complete file; a power cut can
/// damage only what was not yet synced. A file that is not empty is never overwritten.
/// Thread: one at a time; after it was created, that of the RecordWriter.
class RecordFile {
 public:
  /// Fails with ErrorKind::Failed and the reason if the file cannot be created or locked, is not a
  /// regular file, or is not empty.
  [[nodiscard]] static Result<RecordFile> create(const std::filesystem::path& path,
                                                 const RecordForm& form = kStreamFileForm);
  RecordFile(RecordFile&& other) noexcept = default;
  RecordFile& operator=(RecordFile&&) = delete;
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  /// Removes the file if create() made it and nothing was added.
  ~RecordFile();

  /// Adds a piece. If that fails, the file stays as it was.
  [[nodiscard]] Result<void> add(std::string_view piece);
  /// Syncs to the disk what was added; the first time, the file's name too.
  [[nodiscard]] Result<void> sync();

 private:
  RecordFile(std::filesystem::path path, const RecordForm& form, Descriptor file, bool made);
  [[nodiscard]] Error failed() const;

  std::filesystem::path path_;
  RecordForm form_;
  Descriptor file_;
  bool made_;             ///< the file did not exist before
  bool named_ = false;    ///< its folder was synced
  std::int64_t end_ = 0;  ///< position of the tail; 0: nothing was added yet
};

}  // namespace aucast::server
