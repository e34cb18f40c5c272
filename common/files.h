#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast {

/// The whole of a regular file, and never a wait: a FIFO, a socket, a device (but /dev/null, which
/// is empty) or a folder is Unreadable, and so is a file of more than `bytes_max` bytes, before any
/// of them is read, and one that goes on growing. The message has the path and the cause.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path,
                                            std::size_t bytes_max = std::size_t{256} << 20U);

/// Standard input up to its end, whatever it is; waits for whoever writes it.
[[nodiscard]] Result<std::string> read_standard_input(std::size_t bytes_max = std::size_t{256}
                                                                              << 20U);

/// A descriptor of a regular file, for a library that reads by itself; the caller closes it. What
/// read_file() refuses for its kind is Unreadable here too.
[[nodiscard]] Result<int> open_file(const std::filesystem::path& path);

/// A file that holds a secret.
struct SecretFile {
  std::string bytes;
  /// Other users have access to it. A group may: services are often let in as one.
  bool open_to_others = false;
};

/// read_file() for a token or a private key.
[[nodiscard]] Result<SecretFile> read_secret_file(const std::filesystem::path& path,
                                                  std::size_t bytes_max);

/// Writes the file whole or not at all: a temporary file beside it, synced, then a rename, which
/// replaces a symbolic link and does not follow it. The mode of a file that was there stays. A
/// device or a FIFO with a reader is written directly. Failed, with the path and the cause, when
/// the place cannot be written; what was there before then stays.
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& path,
                                                 std::string_view bytes);

/// Whether write_file_atomically() would work now, of a FIFO as soon as somebody reads it. Changes
/// nothing, and is no end to who reads a FIFO already.
[[nodiscard]] Result<void> check_writable(const std::filesystem::path& path);

/// From here on a write beyond the file size limit (RLIMIT_FSIZE) fails with EFBIG, as one to a
/// full disk does, and no longer ends the program.
void ignore_file_size_signal();

/// A new, empty file beside `path` for a program that writes by itself. Its name is random, and it
/// is never a file or link of anybody else's. replace_file() makes it `path`.
[[nodiscard]] Result<std::filesystem::path> create_temporary_beside(
    const std::filesystem::path& path);

/// Syncs `temporary` and renames it to `path`, whose mode it gets if there was such a file. Removes
/// it when that fails.
[[nodiscard]] Result<void> replace_file(const std::filesystem::path& temporary,
                                        const std::filesystem::path& path);

/// `path` from the root, for people and for later: as it is when there is no current folder any
/// more.
[[nodiscard]] std::filesystem::path whole_path(const std::filesystem::path& path);

/// Where a user keeps files of one kind: $XDG_..._HOME (`xdg`), else `usual` below $HOME; null when
/// unset. A relative one counts as unset, as the specification wants. Nothing when neither is set.
[[nodiscard]] std::optional<std::filesystem::path> users_folder(const char* xdg, const char* home,
                                                                const char* usual);

/// The folder that this program lies in; nothing when the system does not tell.
[[nodiscard]] std::optional<std::filesystem::path> program_folder();

/// The folder data/ of the project: `chosen` (from --data) if not empty, else $AUCAST_DATA, else
/// data/ beside the executable, else ../share/aucast beside it. Never the current folder.
/// Unreadable, naming the places tried, when there is none.
[[nodiscard]] Result<std::filesystem::path> find_data_folder(const std::filesystem::path& chosen);

}  // namespace aucast
