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

/// Why an open file cannot be taken; empty: it can.
std::string objection(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return system_reason(errno);
  if (!S_ISREG(status.st_mode)) return "it is no plain file";
  if (status.st_size > 0) return "it holds something already, which --record never writes over";
  // Two that write at once would make one that nobody can read.
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return "another program is recording to it";
  return "";
}

}  // namespace

RecordFile::RecordFile(std::filesystem::path path, const RecordForm& form, int descriptor,
                       bool made)
    : path_(std::move(path)), form_(form), descriptor_(descriptor), made_(made) {}

RecordFile::RecordFile(RecordFile&& other) noexcept
    : path_(std::move(other.path_)),
      form_(other.form_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      made_(other.made_),
      end_(other.end_) {}

RecordFile::~RecordFile() {
  if (descriptor_ < 0) return;
  if (made_ && end_ == 0) ::unlink(path_.c_str());
  ::close(descriptor_);
}

Result<RecordFile> RecordFile::create(const std::filesystem::path& path, const RecordForm& form) {
  // Not blocking: a FIFO that nobody reads would be waited for.
  constexpr int kFlags = O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK;
  int descriptor = ::open(path.c_str(), kFlags | O_EXCL, 0644);
  const bool made = descriptor >= 0;
  if (!made) descriptor = ::open(path.c_str(), kFlags, 0644);
  if (descriptor < 0) return cannot_record(path, system_reason(errno));
  if (const std::string why = objection(descriptor); !why.empty()) {
    ::close(descriptor);
    return cannot_record(path, why);
  }
  return RecordFile(path, form, descriptor, made);
}

Error RecordFile::failed() const {
  return {ErrorKind::Failed,
          at_place(path_.string(), "cannot be written: " + system_reason(errno))};
}

Result<void> RecordFile::add(std::string_view piece) {
  std::string text(end_ == 0 ? form_.head : "");
  text += piece;
  const std::int64_t end = end_ + static_cast<std::int64_t>(text.size());
  if (write_at(descriptor_, text + std::string(form_.tail), end_)) {
    end_ = end;
    return {};
  }
  const Error error = failed();
  // The place of the old end is ours already, also on a full disk.
  const std::string_view old_end = end_ == 0 ? "" : form_.tail;
  if (!write_at(descriptor_, old_end, end_) ||
      ::ftruncate(descriptor_, end_ + static_cast<std::int64_t>(old_end.size())) != 0) {
    return Error{error.kind, error.message + "; what was added last may be torn"};
  }
  return error;
}

Result<void> RecordFile::sync() {
  if (::fdatasync(descriptor_) == 0) return {};
  return failed();
}

}  // namespace aucast::server
