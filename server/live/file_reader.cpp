#include "server/live/file_reader.h"

#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <system_error>
#include <utility>

#include <asio/post.hpp>

namespace aucast::server {
namespace {

/// How often a file is checked even without a report of a change: not every file system reports
/// them.
constexpr std::chrono::milliseconds kLookEvery{100};
/// How many bytes before the present position are compared, to see whether a file was rewritten.
constexpr std::size_t kTailBytes = 256;

}  // namespace

FileReader::FileReader(asio::io_context& io, std::filesystem::path path, Descriptor file,
                       bool follow, const Events& events)
    : InputReader(std::move(path), events),
      io_(io),
      file_(std::move(file)),
      follow_(follow),
      notify_(io),
      timer_(io) {}

void FileReader::start() {
  find_place();
  watch();
  await();
}

/// Begins where whoever gave us the file has left it, with what is before that as the tail.
void FileReader::find_place() {
  position_ = std::max<std::int64_t>(::lseek(file_.get(), 0, SEEK_CUR), 0);
  tail_.resize(std::min(static_cast<std::size_t>(position_), kTailBytes));
  const auto begin = position_ - static_cast<std::int64_t>(tail_.size());
  const ssize_t got = ::pread(file_.get(), tail_.data(), tail_.size(), begin);
  if (got < static_cast<ssize_t>(tail_.size())) tail_.clear();
}

void FileReader::watch() {
  if (!follow_ || is_stdin()) return;
  Descriptor changes(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
  if (changes.open() && changes.hand_to(notify_)) watch_file();
}

/// Watches the file that is there now, and no longer the one before. Where that fails, we look
/// every kLookEvery all the same.
void FileReader::watch_file() {
  if (!notify_.is_open()) return;
  if (watch_ >= 0) ::inotify_rm_watch(notify_.native_handle(), watch_);
  watch_ = ::inotify_add_watch(notify_.native_handle(), path_.c_str(), IN_MODIFY);
}

void FileReader::stop() {
  stopped_ = true;
  waits_.cancel();
  std::error_code ignored;
  notify_.close(ignored);
  timer_.cancel();
}

/// Reads on as soon as the event loop has time.
void FileReader::wait_for_bytes() {
  asio::post(io_, [this, wait = waits_.begin()] {
    if (!wait.current()) return;
    waiting_ = false;
    read();
  });
}

void FileReader::pass_on(std::string_view bytes) {
  position_ += static_cast<std::int64_t>(bytes.size());
  tail_ += bytes.substr(bytes.size() - std::min(bytes.size(), kTailBytes));
  if (tail_.size() > kTailBytes) tail_.erase(0, tail_.size() - kTailBytes);
  events_.on_bytes(bytes);
}

void FileReader::read() {
  if (!reading_) return;
  // What changes from here on is noticed again.
  while (notify_.is_open() && ::read(notify_.native_handle(), chunk_.data(), chunk_.size()) > 0) {
  }
  if (const std::string why = follow_ ? changed() : ""; !why.empty() && !begin_anew(why)) {
    return look_again();
  }
  const ssize_t got = ::pread(file_.get(), chunk_.data(), chunk_.size(), position_);
  if (got < 0) events_.on_failure(unreadable_now(path_));
  if (got > 0) {
    pass_on({chunk_.data(), static_cast<std::size_t>(got)});
    await();
  } else if (!follow_) {
    stopped_ = true;
    events_.on_end();
  } else {
    if (got == 0) events_.on_caught_up();
    look_again();
  }
}

/// Waits until the file is changed, or for a moment.
void FileReader::look_again() {
  if (stopped_ || waiting_) return;
  waiting_ = true;
  // Both may be queued already when the first of them is called.
  const auto look = [this, wait = waits_.begin()](const std::error_code& /*error*/) {
    if (wait.current()) on_look();
  };
  timer_.expires_after(kLookEvery);
  timer_.async_wait(look);
  if (!notify_.is_open()) return;
  notify_.async_wait(asio::posix::stream_descriptor::wait_read, look);
}

void FileReader::on_look() {
  waits_.cancel();
  waiting_ = false;
  timer_.cancel();
  std::error_code ignored;
  if (notify_.is_open()) notify_.cancel(ignored);
  read();
}

bool FileReader::replaced() const {
  struct stat ours {};
  struct stat there {};
  if (is_stdin() || ::stat(path_.c_str(), &there) != 0 || ::fstat(file_.get(), &ours) != 0) {
    return false;
  }
  return ours.st_ino != there.st_ino || ours.st_dev != there.st_dev;
}

/// Why the file must be read anew; empty: it only grew.
std::string FileReader::changed() const {
  if (replaced()) return "it was replaced";
  std::string now(tail_.size(), '\0');
  const auto begin = position_ - static_cast<std::int64_t>(tail_.size());
  const ssize_t got = ::pread(file_.get(), now.data(), now.size(), begin);
  if (got < 0) return "";  // to read on will not do either, and that is said
  if (got < static_cast<ssize_t>(tail_.size())) return "it got shorter";
  return now == tail_ ? "" : "it was rewritten";
}

/// False: there is another file, which cannot be opened.
bool FileReader::begin_anew(const std::string& why) {
  if (replaced()) {
    Descriptor now(::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (!now.open()) {
      // One that has just gone may be replaced in its turn.
      if (errno != ENOENT) events_.on_failure(unreadable_now(path_));
      return false;
    }
    file_ = std::move(now);
    watch_file();
  }
  position_ = 0;
  tail_.clear();
  events_.on_anew(why);
  return true;
}

}  // namespace aucast::server
