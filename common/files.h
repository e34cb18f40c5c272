#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast {

/// The whole file. Unreadable (with the system's reason) when it cannot be opened or read, is a
/// folder, or is longer than `bytes_max`.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path,
                                            std::size_t bytes_max = std::size_t{256} << 20U);

/// Writes the file whole or not at all: a temporary file beside it, then a rename. Failed (with the
/// system's reason) when the place cannot be written; what was there before then stays.
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& path,
                                                 std::string_view bytes);

/// The folder data/ of the project: `chosen` (from --data) if not empty, else $AUCAST_DATA, else
/// data/ beside the executable, else ../share/aucast beside it. Never the current folder.
/// Unreadable, naming the places tried, when there is none.
[[nodiscard]] Result<std::filesystem::path> find_data_folder(const std::filesystem::path& chosen);

}  // namespace aucast
