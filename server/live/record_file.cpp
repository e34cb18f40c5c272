#include "server/live/record_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <utility>

#include "common/text.h"
#include "protocol/stream_file.h"

namespace aucast::server {
namespace {

static_assert(kStreamFileForm.head.starts_with(protocol::kBeginTag));
static_assert(kStreamFileForm.tail.starts_with(protocol::kEndTag));

Error cannot_record(const std::filesystem::path& path, const std::string& why) {
  return {ErrorKind::Failed, at_place(path.string(), "cannot be recorded to: " + why)};
}

bool write_at(int descriptor, std::string_view bytes, std::int64_t place) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor, bytes.data(), bytes.size(), place);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
    place += written;
  }
  return true;
}

struct Objection {
  std::string why;      ///< an open file cannot be taken; empty: it can
  bool others = false;  ///< something else may be written to it
};

/// Locks the file. What it holds counts only then: another program that had it may have written to
/// it until now.
Objection objection(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return {system_reason(errno)};
  if (!S_ISREG(status.st_mode)) {
    return {"it is no plain file; give --record a new file, or a folder that is there"};
  }
  // Two that write at once would make one that nobody can read.
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return {"another program is recording to it", true};
    return {"it cannot be locked: " + system_reason(errno) + "; record to a disk of this computer"};
  }
  if (::fstat(descriptor, &status) != 0) return {system_reason(errno)};
  if (status.st_size > 0) {
    return {"it holds something already, which --record never writes over", true};
  }
  return {};
}

/// Whether the open file is the one at `path`. One that another program has removed would take a
/// record that nobody finds.
bool is_at(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// A new file outlives a power cut only if its name, which is kept in the folder, does. What cannot
/// be synced is as good as it gets: some file systems cannot, and a folder may be unreadable.
void sync_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.open()) ::fsync(opened.get());
}

}  // namespace

RecordFile::RecordFile(std::filesystem::path path, const RecordForm& form, Descriptor file,
                       bool made)
    : path_(std::move(path)), form_(form), file_(std::move(file)), made_(made) {}

RecordFile::~RecordFile() {
  if (file_.open() && made_ && end_ == 0 && is_at(file_.get(), path_)) ::unlink(path_.c_str());
}

Result<RecordFile> RecordFile::create(const std::filesystem::path& path, const RecordForm& form) {
  // Not blocking: a FIFO that nobody reads would be waited for.
  constexpr int kFlags = O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK;
  constexpr int kAttempts = 8;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Descriptor file(::open(path.c_str(), kFlags | O_EXCL, 0644));
    const bool made = file.open();
    if (!made) file = Descriptor(::open(path.c_str(), kFlags, 0644));
    if (!file.open()) return cannot_record(path, system_reason(errno) + "; choose another place");
    if (const Objection objected = objection(file.get()); !objected.why.empty()) {
      // Another program that was quicker to lock the file writes to it now.
      if (made && !objected.others) ::unlink(path.c_str());
      return cannot_record(path, objected.why);
    }
    if (is_at(file.get(), path)) return RecordFile(path, form, std::move(file), made);
  }
  return cannot_record(path, "another program removes it again and again");
}

Error RecordFile::failed() const {
  return {ErrorKind::Failed,
          at_place(path_.string(), "cannot be written: " + system_reason(errno))};
}

Result<void> RecordFile::add(std::string_view piece) {
  std::string text(end_ == 0 ? form_.head : "");
  text += piece;
  const std::int64_t end = end_ + static_cast<std::int64_t>(text.size());
  if (write_at(file_.get(), text + std::string(form_.tail), end_)) {
    end_ = end;
    return {};
  }
  const Error error = failed();
  // The place of the old end is ours already, also on a full disk.
  const std::string_view old_end = end_ == 0 ? "" : form_.tail;
  if (!write_at(file_.get(), old_end, end_) ||
      ::ftruncate(file_.get(), end_ + static_cast<std::int64_t>(old_end.size())) != 0) {
    return Error{error.kind, error.message + "; what was added last may be torn"};
  }
  return error;
}

Result<void> RecordFile::sync() {
  if (::fdatasync(file_.get()) != 0) return failed();
  if (!std::exchange(named_, true)) sync_folder_of(path_);
  return {};
}

}  // namespace aucast::server
