#include "common/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include "common/text.h"

namespace aucast {
namespace {

Error unreadable(const std::filesystem::path& path, std::string_view why) {
  return {ErrorKind::Unreadable, path.string() + ": cannot be read: " + std::string(why)};
}

Error unwritable(const std::filesystem::path& path, std::string_view why) {
  return {ErrorKind::Failed, path.string() + ": cannot be written: " + std::string(why)};
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return value_; }
  /// Closes now and says whether that worked: some file systems report a full disk only here.
  [[nodiscard]] bool close() { return ::close(std::exchange(value_, -1)) == 0; }

 private:
  int value_;
};

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::size_t bytes_max) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return unreadable(path, system_reason(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return unreadable(path, system_reason(errno));
  if (S_ISDIR(status.st_mode)) return unreadable(path, "it is a folder");
  std::string bytes;
  std::vector<char> chunk(std::size_t{1} << 16U);
  for (;;) {
    const ssize_t got = ::read(file.get(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unreadable(path, system_reason(errno));
    if (got == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
    if (bytes.size() > bytes_max) {
      return unreadable(path, "it is longer than " + std::to_string(bytes_max) + " bytes");
    }
  }
}

Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code status_error;
  const auto status = std::filesystem::status(path, status_error);
  if (std::filesystem::is_directory(status)) return unwritable(path, "it is a folder");
  // A device or a pipe (/dev/stdout) has no "beside it" and nothing to lose: write it directly.
  const bool special = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  std::filesystem::path temporary = path;
  if (!special) temporary += ".part-" + std::to_string(::getpid());
  const int flags = special ? O_WRONLY | O_CLOEXEC : O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC;
  Descriptor file(::open(temporary.c_str(), flags, 0644));
  if (file.get() < 0) return unwritable(path, system_reason(errno));
  if (!write_all(file.get(), bytes) || (!special && ::fsync(file.get()) != 0) || !file.close()) {
    const int error_number = errno;
    if (!special) ::unlink(temporary.c_str());
    return unwritable(path, system_reason(error_number));
  }
  if (!special && ::rename(temporary.c_str(), path.c_str()) != 0) {
    const int error_number = errno;
    ::unlink(temporary.c_str());
    return unwritable(path, system_reason(error_number));
  }
  return {};
}

Result<std::filesystem::path> find_data_folder(const std::filesystem::path& chosen) {
  std::vector<std::filesystem::path> places;
  if (!chosen.empty()) {
    places.push_back(chosen);
  } else if (const char* named = std::getenv("AUCAST_DATA"); named != nullptr && *named != '\0') {
    places.emplace_back(named);
  } else {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) {
      places.push_back(program.parent_path() / "data");
      places.push_back(program.parent_path().parent_path() / "share" / "aucast");
    }
  }
  std::string tried;
  for (const auto& place : places) {
    std::error_code error;
    if (std::filesystem::is_directory(place, error)) return place;
    tried += (tried.empty() ? "" : ", ") + place.string();
  }
  return Error{ErrorKind::Unreadable,
               "no data folder (tried " + tried + "): name it with --data DIR or AUCAST_DATA"};
}

}  // namespace aucast
