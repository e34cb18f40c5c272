#include "server/live/live_input.h"

#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <asio/post.hpp>

#include "common/log.h"
#include "common/text.h"

namespace aucast::server {
namespace {

constexpr std::size_t kChunkBytes = 16384;
/// A file is looked at so often even if nobody says that it changed: not every file system does.
constexpr std::chrono::milliseconds kLookEvery{100};
/// So many bytes before the present place are compared to see whether a file was rewritten.
constexpr std::size_t kTailBytes = 256;

/// Of files and some devices the kernel does not tell when there is more: they are looked at by the
/// clock.
bool can_be_waited_for(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return false;
  return S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode) || ::isatty(descriptor) != 0;
}

}  // namespace

LiveInput::LiveInput(asio::io_context& io, std::filesystem::path path, bool follow, Events events,
                     Opener open)
    : io_(io),
      path_(std::move(path)),
      follow_(follow),
      events_(std::move(events)),
      open_(std::move(open)),
      stream_(io),
      notify_(io),
      timer_(io),
      chunk_(kChunkBytes) {}

LiveInput::~LiveInput() {
  *alive_ = false;
  if (file_ >= 0) ::close(file_);
}

Result<int> LiveInput::open_path() const {
  if (open_) return open_();
  // Of stdin a copy: closing ours must not close it. Not O_NONBLOCK, which whoever shares it with
  // us would get too.
  const int descriptor = path_ == "-" ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                                      : ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  return unreadable();
}

/// Of the call that has just failed.
Error LiveInput::unreadable() const {
  return {ErrorKind::Unreadable,
          at_place(path_.string(), "cannot be read: " + system_reason(errno))};
}

void LiveInput::note_failure(Error failure) {
  if (!failure_) spdlog::error("{}", failure.message);
  failure_ = std::move(failure);
}

void LiveInput::take(int descriptor) {
  if (can_be_waited_for(descriptor)) {
    std::error_code error;
    stream_.assign(descriptor, error);
    if (!error) return;
  }
  file_ = descriptor;
  position_ = 0;
  tail_.clear();
}

Result<void> LiveInput::start() {
  const auto descriptor = open_path();
  if (!descriptor) return descriptor.error();
  take(*descriptor);
  if (file_ >= 0) watch();
  await();
  return {};
}

void LiveInput::watch() {
  if (!follow_ || path_ == "-") return;
  const int descriptor = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  if (descriptor < 0) return;
  std::error_code error;
  notify_.assign(descriptor, error);
  if (error) {
    ::close(descriptor);
  } else {
    ::inotify_add_watch(descriptor, path_.c_str(), IN_MODIFY);
  }
}

void LiveInput::hold(bool held) {
  if (std::exchange(held_, held) && !held) await();
}

void LiveInput::stop() {
  stopped_ = true;
  std::error_code ignored;
  stream_.close(ignored);
  notify_.close(ignored);
  timer_.cancel();
}

/// Goes on reading when there may be something.
void LiveInput::await() {
  if (held_ || stopped_ || ended_ || waiting_) return;
  waiting_ = true;
  if (file_ >= 0) {
    asio::post(io_, [this, alive = alive_] {
      if (!*alive) return;
      waiting_ = false;
      if (!stopped_) read_file();
    });
    return;
  }
  stream_.async_wait(asio::posix::stream_descriptor::wait_read,
                     [this, alive = alive_](const std::error_code& error) {
                       if (!*alive || stopped_) return;
                       waiting_ = false;
                       if (!error) read_stream();
                     });
}

void LiveInput::read_stream() {
  const ssize_t got = ::read(stream_.native_handle(), chunk_.data(), chunk_.size());
  if (got > 0) {
    pass_on({chunk_.data(), static_cast<std::size_t>(got)});
  } else if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
    if (got < 0) note_failure(unreadable());
    stream_ended();
  }
  await();
}

/// A FIFO may get another writer; a pipe does not.
void LiveInput::stream_ended() {
  std::error_code ignored;
  if (path_ == "-" || open_) {
    ended_ = true;
    stream_.close(ignored);
    events_.on_end();
    return;
  }
  // Opened before the old end is closed: a FIFO that nobody holds forgets what the next writer has
  // already said.
  const auto descriptor = open_path();
  stream_.close(ignored);
  if (descriptor) {
    take(*descriptor);
  } else {
    note_failure(descriptor.error());
    ended_ = true;
  }
  events_.on_end();
}

void LiveInput::pass_on(std::string_view bytes) {
  failure_.reset();
  position_ += static_cast<std::int64_t>(bytes.size());
  tail_ += bytes.substr(bytes.size() - std::min(bytes.size(), kTailBytes));
  if (tail_.size() > kTailBytes) tail_.erase(0, tail_.size() - kTailBytes);
  events_.on_bytes(bytes);
}

void LiveInput::read_file() {
  if (held_) return;
  // What changes from here on is noticed again.
  while (notify_.is_open() && ::read(notify_.native_handle(), chunk_.data(), chunk_.size()) > 0) {
  }
  if (const std::string why = follow_ ? changed() : ""; !why.empty()) begin_anew(why);
  // stdin has its own place, which whoever gave it to us may have chosen.
  const ssize_t got = path_ == "-" ? ::read(file_, chunk_.data(), chunk_.size())
                                   : ::pread(file_, chunk_.data(), chunk_.size(), position_);
  if (got < 0) note_failure(unreadable());
  if (got > 0) {
    pass_on({chunk_.data(), static_cast<std::size_t>(got)});
    await();
  } else if (!follow_) {
    ended_ = true;
    events_.on_end();
  } else {
    events_.on_caught_up();
    look_again();
  }
}

/// Waits until the file is changed, or for a moment.
void LiveInput::look_again() {
  if (stopped_ || waiting_) return;
  waiting_ = true;
  const auto look = [this, alive = alive_](const std::error_code& error) {
    if (error == asio::error::operation_aborted || !*alive || stopped_ || !waiting_) return;
    waiting_ = false;
    timer_.cancel();
    std::error_code ignored;
    if (notify_.is_open()) notify_.cancel(ignored);
    read_file();
  };
  timer_.expires_after(kLookEvery);
  timer_.async_wait(look);
  if (!notify_.is_open()) return;
  notify_.async_wait(asio::posix::stream_descriptor::wait_read, look);
}

bool LiveInput::replaced() const {
  struct stat ours {};
  struct stat there {};
  if (path_ == "-" || ::stat(path_.c_str(), &there) != 0 || ::fstat(file_, &ours) != 0) {
    return false;
  }
  return ours.st_ino != there.st_ino || ours.st_dev != there.st_dev;
}

/// Why the file must be read anew; empty: it only grew.
std::string LiveInput::changed() const {
  if (replaced()) return "it was replaced";
  std::string now(tail_.size(), '\0');
  const auto begin = position_ - static_cast<std::int64_t>(tail_.size());
  const ssize_t got = ::pread(file_, now.data(), now.size(), begin);
  if (got < 0) return "";  // to read on will not do either, and that is said
  if (got < static_cast<ssize_t>(tail_.size())) return "it got shorter";
  return now == tail_ ? "" : "it was rewritten";
}

void LiveInput::begin_anew(const std::string& why) {
  if (path_ != "-" && replaced()) {
    const auto descriptor = open_path();
    if (!descriptor) return;
    ::close(std::exchange(file_, *descriptor));
    if (notify_.is_open()) {
      ::inotify_add_watch(notify_.native_handle(), path_.c_str(), IN_MODIFY);
    }
  }
  position_ = 0;
  tail_.clear();
  events_.on_anew(why);
}

}  // namespace aucast::server
