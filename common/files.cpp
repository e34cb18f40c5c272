#include "common/files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <system_error>
#include <utility>
#include <vector>

#include "common/number_of.h"
#include "common/text.h"

namespace aucast {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReadBytes = std::size_t{1} << 16U;

/// How much a file may grow while it is read. Files of /proc are endless and say they are empty.
constexpr std::size_t kGrowthMax = std::size_t{1} << 20U;

Error unreadable(const fs::path& path, std::string_view why) {
  return {ErrorKind::Unreadable, at_place(path.string(), "cannot be read: " + std::string(why))};
}

Error unwritable(const fs::path& path, std::string_view why) {
  return {ErrorKind::Failed, at_place(path.string(), "cannot be written: " + std::string(why))};
}

/// The same for a file that cannot be opened, with the remedy.
Error unreadable(const fs::path& path, int error_number) {
  std::string why = system_reason(error_number);
  if (error_number == ENOENT || error_number == ENOTDIR) why += "; check the name";
  if (error_number == EACCES) why += "; check its permissions";
  return unreadable(path, why);
}

Error unwritable(const fs::path& path, int error_number) {
  std::string why = system_reason(error_number);
  const bool no_place = error_number == ENOENT || error_number == ENOTDIR ||
                        error_number == EACCES || error_number == EROFS;
  if (no_place) why += "; choose another folder";
  return unwritable(path, why);
}

std::string longer_than(std::size_t bytes_max) {
  return "it is longer than " + std::to_string(bytes_max) + " bytes";
}

/// Why an open file cannot be read; empty: it can.
std::string_view objection(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return "";
  if (S_ISDIR(status.st_mode)) return "it is a folder";
  if (S_ISFIFO(status.st_mode)) return "it is a pipe, not a file";
  const bool is_null = S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
  return is_null ? "" : "it is a device, not a file";
}

/// Appends up to kReadBytes; 0 at the end, negative (errno) on failure.
ssize_t read_some(int descriptor, std::string& bytes) {
  std::array<char, kReadBytes> chunk;
  for (;;) {
    const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got > 0) bytes.append(chunk.data(), static_cast<std::size_t>(got));
    return got;
  }
}

Result<std::string> read_open(const Descriptor& file, const struct stat& status,
                              const fs::path& path, std::size_t bytes_max,
                              const StopToken& stop = {}) {
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > bytes_max) return unreadable(path, longer_than(bytes_max));
  std::string bytes;
  bytes.reserve(size);
  for (;;) {
    if (stop.stop_requested()) return stopped_early();
    const ssize_t got = read_some(file.get(), bytes);
    if (got < 0) return unreadable(path, system_reason(errno));
    if (got == 0) return bytes;
    if (bytes.size() > bytes_max) return unreadable(path, longer_than(bytes_max));
    if (bytes.size() > size + kGrowthMax) return unreadable(path, "it grows while it is read");
  }
}

Result<std::pair<Descriptor, struct stat>> open_to_read(const fs::path& path) {
  // Not blocking: a FIFO would be waited for.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  struct stat status {};
  if (!file.open() || ::fstat(file.get(), &status) != 0) return unreadable(path, errno);
  if (const auto why = objection(status); !why.empty()) return unreadable(path, why);
  return std::pair{std::move(file), status};
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Why what is at a path can never be written as a file; empty: perhaps it can.
std::string_view objection(const fs::file_status& status) {
  if (fs::is_directory(status)) return "it is a folder";
  return fs::is_socket(status) ? "it is a socket" : "";
}

/// A name of the system's that stands for something open, such as /dev/stdout: another file in its
/// place would harm all programs.
bool is_system_name(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(fs::absolute(path, ignored).parent_path(), ignored);
  return folder == "/dev" || folder.native().starts_with("/proc/");
}

/// A device or a FIFO has no "beside it" and nothing to lose: it is written directly.
bool is_special(const fs::path& path, const fs::file_status& status) {
  return (fs::exists(status) && !fs::is_regular_file(status)) || is_system_name(path);
}

/// The descriptor of our own that a name such as /dev/stdout or /dev/fd/3 stands for, if any.
std::optional<int> own_descriptor(const fs::path& path) {
  std::error_code ignored;
  const fs::path whole = fs::absolute(path, ignored).lexically_normal();
  if (whole == "/dev/stdout") return STDOUT_FILENO;
  if (whole == "/dev/stderr") return STDERR_FILENO;
  const fs::path folder = fs::weakly_canonical(whole.parent_path(), ignored);
  if (folder != "/proc/" + std::to_string(::getpid()) + "/fd") return std::nullopt;
  return number_of<int>(whole.filename().native());
}

/// What is written goes behind what this program has written there before, and before what follows:
/// opened anew, a file would be written from another place.
Result<void> write_to_own(const fs::path& path, int descriptor, std::string_view bytes) {
  std::fflush(nullptr);
  Descriptor file(::fcntl(descriptor, F_DUPFD_CLOEXEC, 0));
  if (!file.open() || !write_all(file.get(), bytes) || !file.close()) {
    return unwritable(path, system_reason(errno));
  }
  return {};
}

/// Whether write_to_own() can write there, by how the descriptor was opened: what is at the path
/// may not be openable at all, as a socket is not.
Result<void> check_own(const fs::path& path, int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags < 0) return unwritable(path, system_reason(errno));
  if ((flags & O_ACCMODE) == O_RDONLY) return unwritable(path, "it is open for reading only");
  return {};
}

Result<void> write_special(const fs::path& path, const fs::file_status& status,
                           std::string_view bytes) {
  // Opened without blocking, so that a FIFO without a reader is an error and not a wait.
  Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!file.open()) {
    const bool alone = errno == ENXIO && fs::is_fifo(status);
    return unwritable(path, alone ? "nobody reads it" : system_reason(errno));
  }
  static_cast<void>(::fcntl(file.get(), F_SETFL, O_WRONLY | O_APPEND));
  if (!write_all(file.get(), bytes) || !file.close()) {
    return unwritable(path, system_reason(errno));
  }
  return {};
}

/// A new file and its name.
struct Temporary {
  fs::path path;
  Descriptor file;
};

Result<Temporary> open_temporary_beside(const fs::path& path) {
  constexpr int kAttempts = 100;
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  std::random_device random;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    fs::path temporary = path;
    temporary += std::string(kTemporaryMark) + std::to_string(random());
    Descriptor file(::open(temporary.c_str(), kFlags, 0644));
    if (file.open()) return Temporary{std::move(temporary), std::move(file)};
    if (errno != EEXIST) break;
  }
  return unwritable(path, errno);
}

/// Gives the new file the mode of the file that it replaces; where there was none, it keeps its
/// own.
bool keep_mode(int file, const fs::file_status& before) {
  const auto mode = static_cast<mode_t>(before.permissions() & fs::perms::all);
  return !fs::exists(before) || ::fchmod(file, mode) == 0;
}

/// Gives the temporary file the name and mode of the file that it replaces once it is on the disk.
/// If that fails, or it is not `whole`, removes it; errno has the reason.
Result<void> give_name(Descriptor& file, bool whole, const fs::path& temporary,
                       const fs::path& path, const fs::file_status& before) {
  const bool done = whole && keep_mode(file.get(), before) && ::fsync(file.get()) == 0 &&
                    file.close() && ::rename(temporary.c_str(), path.c_str()) == 0;
  if (done) return {};
  const int error_number = errno;
  ::unlink(temporary.c_str());
  return unwritable(path, system_reason(error_number));
}

}  // namespace

Result<std::string> read_file(const fs::path& path, std::size_t bytes_max, const StopToken& stop) {
  const auto opened = open_to_read(path);
  if (!opened) return opened.error();
  return read_open(opened->first, opened->second, path, bytes_max, stop);
}

Result<Descriptor> open_file(const fs::path& path) {
  auto opened = open_to_read(path);
  if (!opened) return opened.error();
  return std::move(opened->first);
}

std::string bytes_at(int descriptor, std::int64_t position, std::size_t count) {
  std::string bytes(count, '\0');
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got = ::pread(descriptor, bytes.data() + done, count - done,
                                position + static_cast<std::int64_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

std::int64_t file_size(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? status.st_size : 0;
}

Result<SecretFile> read_secret_file(const fs::path& path, std::size_t bytes_max) {
  const auto opened = open_to_read(path);
  if (!opened) return opened.error();
  auto bytes = read_open(opened->first, opened->second, path, bytes_max);
  if (!bytes) return bytes.error();
  return SecretFile{std::move(*bytes), (opened->second.st_mode & S_IRWXO) != 0};
}

Result<std::string> read_standard_input(std::size_t bytes_max) {
  std::string bytes;
  for (;;) {
    const ssize_t got = read_some(STDIN_FILENO, bytes);
    if (got == 0) return bytes;
    if (got < 0 && errno == EAGAIN) {  // whoever gave it to us does not block on it
      pollfd input{STDIN_FILENO, POLLIN, 0};
      static_cast<void>(::poll(&input, 1, -1));
    } else if (got < 0) {
      return unreadable("stdin", system_reason(errno));
    }
    if (bytes.size() > bytes_max) return unreadable("stdin", longer_than(bytes_max));
  }
}

Result<void> write_file_atomically(const fs::path& path, std::string_view bytes) {
  std::error_code ignored;
  if (const auto own = own_descriptor(path)) return write_to_own(path, *own, bytes);
  const fs::file_status status = fs::status(path, ignored);
  if (const auto why = objection(status); !why.empty()) return unwritable(path, why);
  if (is_special(path, status)) return write_special(path, status, bytes);
  auto temporary = open_temporary_beside(path);
  if (!temporary) return temporary.error();
  const bool whole = write_all(temporary->file.get(), bytes);
  return give_name(temporary->file, whole, temporary->path, path, status);
}

Result<void> check_writable(const fs::path& path) {
  std::error_code ignored;
  if (const auto own = own_descriptor(path)) return check_own(path, *own);
  const fs::file_status status = fs::status(path, ignored);
  if (const auto why = objection(status); !why.empty()) return unwritable(path, why);
  if (is_special(path, status)) {
    // Not opened: to close a FIFO again would be the end to whoever reads it.
    if (::access(path.c_str(), W_OK) == 0) return {};
    return unwritable(path, system_reason(errno));
  }
  const auto temporary = create_temporary_beside(path);
  if (!temporary) return temporary.error();
  ::unlink(temporary->c_str());
  return {};
}

bool written_directly(const fs::path& path) {
  std::error_code ignored;
  return is_special(path, fs::status(path, ignored));
}

void ignore_file_size_signal() {
  std::signal(SIGXFSZ, SIG_IGN);
}

Result<fs::path> create_temporary_beside(const fs::path& path) {
  std::error_code ignored;
  const auto why = objection(fs::status(path, ignored));
  if (!why.empty()) return unwritable(path, why);
  if (is_system_name(path)) return unwritable(path, "it is no place for a file");
  auto temporary = open_temporary_beside(path);
  if (!temporary) return temporary.error();
  return std::move(temporary->path);
}

Result<void> replace_file(const fs::path& temporary, const fs::path& path) {
  std::error_code ignored;
  const fs::file_status before = fs::status(path, ignored);
  Descriptor file(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  return give_name(file, file.open(), temporary, path, before);
}

fs::path whole_path(const fs::path& path) {
  std::error_code gone;
  const fs::path whole = fs::absolute(path, gone);
  return gone ? path : whole.lexically_normal();
}

std::optional<fs::path> users_folder(const char* xdg, const char* home, const char* usual) {
  if (xdg != nullptr && fs::path(xdg).is_absolute()) return xdg;
  if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / usual;
  return std::nullopt;
}

std::optional<fs::path> program_folder() {
  std::error_code error;
  const auto program = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  return program.parent_path();
}

Result<fs::path> find_data_folder(const fs::path& chosen) {
  std::vector<fs::path> places;
  if (!chosen.empty()) {
    places.push_back(chosen);
  } else if (const char* named = std::getenv("AUCAST_DATA"); named != nullptr && *named != '\0') {
    places.emplace_back(named);
  } else {
    if (const auto programs = program_folder()) {
      places.push_back(*programs / "data");
      places.push_back(programs->parent_path() / "share" / "aucast");
    }
  }
  std::string tried;
  for (const auto& place : places) {
    std::error_code error;
    if (fs::is_directory(place, error)) return place;
    tried += (tried.empty() ? "" : ", ") + place.string();
  }
  return Error{ErrorKind::Unreadable, "no data folder (tried " + printable(tried) +
                                          "): name it with --data DIR or AUCAST_DATA"};
}

}  // namespace aucast
