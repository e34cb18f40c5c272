#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/result.h"
#include "common/temporary_file.h"

namespace aucast {

/// Files that belong together: each gets its name when all of them have been written, and if one
/// cannot be written, none does. Only a failure after all has been written, of a rename or of the
/// disk behind it, can leave some of them old and some new; what is a device or a FIFO has been
/// written by then.
class FilesTogether {
 public:
  /// Adds bytes to the end of the file that is being written.
  using Append = std::function<void(std::string_view bytes)>;

  /// Writes a file, all that `write` appends, under a temporary name. What has no "beside it", such
  /// as a device, a FIFO or /dev/stdout, is kept until finish(). Fails with ErrorKind::Failed, the
  /// path and the cause.
  [[nodiscard]] Result<void> add(const std::filesystem::path& path,
                                 const std::function<void(const Append& append)>& write);
  [[nodiscard]] Result<void> add(const std::filesystem::path& path, std::string_view bytes);

  /// Gives all files their names. Call it once, after the last add() and if none of them failed.
  [[nodiscard]] Result<void> finish();

 private:
  std::vector<std::pair<TemporaryFile, std::filesystem::path>> files_;
  std::vector<std::pair<std::string, std::filesystem::path>> direct_;  ///< bytes for what has no
                                                                       ///< "beside it"
};

}  // namespace aucast
