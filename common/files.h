#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/descriptor.h"
#include "common/result.h"
#include "common/stopped.h"

namespace aucast {

/// The limit of read_file() where the caller gives none.
inline constexpr std::size_t kWholeFileBytesMax = std::size_t{256} << 20U;

/// Reads a whole regular file, and never blocks: a FIFO, a socket, a device (except /dev/null,
/// which is empty) or a folder is Unreadable. So is a file of more than `bytes_max` bytes, whether
/// it has that size when it is opened or grows to it. The message has the path and the cause. If
/// asked to stop, reads no further and returns stopped_early().
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path,
                                            std::size_t bytes_max = kWholeFileBytesMax,
                                            const StopToken& stop = {});

/// Reads standard input, of whatever kind it is, to its end; waits for the writer.
[[nodiscard]] Result<std::string> read_standard_input(std::size_t bytes_max = kWholeFileBytesMax);

/// Opens a regular file for a library that does its own reading. Refuses the kinds of files that
/// read_file() refuses.
[[nodiscard]] Result<Descriptor> open_file(const std::filesystem::path& path);

/// `count` bytes of an open file from `position` on; fewer if the file ends or cannot be read. The
/// descriptor's own position stays as it is.
[[nodiscard]] std::string bytes_at(int descriptor, std::int64_t position, std::size_t count);

/// The size of an open file; 0 if the system does not say.
[[nodiscard]] std::int64_t file_size(int descriptor);

/// A file with a secret in it.
struct SecretFile {
  std::string bytes;
  /// Whether users outside the file's group have access to it. The group itself does not count,
  /// since services often get access through one.
  bool open_to_others = false;
};

/// read_file() for a token or a private key.
[[nodiscard]] Result<SecretFile> read_secret_file(const std::filesystem::path& path,
                                                  std::size_t bytes_max);

/// Writes the file whole or not at all: writes and syncs a temporary file beside it, then renames
/// that to `path`. The rename replaces a symbolic link and does not follow it. The mode of an
/// existing file is kept. A device, a FIFO with a reader, and a name that stands for an open file,
/// such as /dev/stdout, are written to directly. If the file cannot be written, fails with
/// ErrorKind::Failed, the path and the cause; an existing file is then unchanged.
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& path,
                                                 std::string_view bytes);

/// Succeeds if write_file_atomically() would succeed now or, for a FIFO, as soon as somebody reads
/// it. Changes nothing; a program that reads the FIFO sees no end of file.
[[nodiscard]] Result<void> check_writable(const std::filesystem::path& path);

/// Whether write_file_atomically() writes to `path` directly, as to a device, and not to a
/// temporary file beside it.
[[nodiscard]] bool written_directly(const std::filesystem::path& path);

/// After this call a write beyond the file size limit (RLIMIT_FSIZE) fails with EFBIG instead of
/// ending the program.
void ignore_file_size_signal();

/// The temporary name of a file that is not complete yet is its final name, this mark and a number.
inline constexpr std::string_view kTemporaryMark = ".part-";

/// Creates an empty file beside `path`, for another program to write to. Its name is random, and it
/// is never somebody else's file or link. replace_file() renames it to `path`.
[[nodiscard]] Result<std::filesystem::path> create_temporary_beside(
    const std::filesystem::path& path);

/// Syncs `temporary` and renames it to `path`. If `path` existed, its mode is kept. Removes
/// `temporary` when that fails.
[[nodiscard]] Result<void> replace_file(const std::filesystem::path& temporary,
                                        const std::filesystem::path& path);

/// The absolute form of `path`, to show it or to use it after the current folder has changed;
/// `path` itself if the current folder is gone.
[[nodiscard]] std::filesystem::path whole_path(const std::filesystem::path& path);

/// Where a user keeps files of one kind: `xdg`, the value of $XDG_..._HOME, else `usual` below
/// `home`, the value of $HOME. `xdg` and `home` are null when unset; a relative path counts as
/// unset, as the XDG specification wants. nullopt when neither is set.
[[nodiscard]] std::optional<std::filesystem::path> users_folder(const char* xdg, const char* home,
                                                                const char* usual);

/// The folder of this program's executable; nullopt when the system does not say.
[[nodiscard]] std::optional<std::filesystem::path> program_folder();

/// The folder data/ of the project: `chosen` (from --data) if not empty, else $AUCAST_DATA, else
/// data/ beside the executable, else ../share/aucast beside it. Never the current folder. If there
/// is none, fails with Unreadable and a message that names the places tried.
[[nodiscard]] Result<std::filesystem::path> find_data_folder(const std::filesystem::path& chosen);

}  // namespace aucast
