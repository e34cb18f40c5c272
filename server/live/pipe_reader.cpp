#include "server/live/pipe_reader.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <utility>

namespace aucast::server {

std::optional<asio::posix::stream_descriptor> PipeReader::take(asio::io_context& io,
                                                               Descriptor& descriptor) {
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0) return std::nullopt;
  const bool tells =
      S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode) || ::isatty(descriptor.get()) != 0;
  if (!tells) return std::nullopt;
  asio::posix::stream_descriptor pipe(io);
  if (!descriptor.hand_to(pipe)) return std::nullopt;
  return pipe;
}

PipeReader::PipeReader(asio::posix::stream_descriptor pipe, std::filesystem::path path,
                       const Events& events)
    : InputReader(std::move(path), events), pipe_(std::move(pipe)) {}

void PipeReader::stop() {
  stopped_ = true;
  waits_.cancel();
  std::error_code ignored;
  pipe_.close(ignored);
}

void PipeReader::wait_for_bytes() {
  pipe_.async_wait(asio::posix::stream_descriptor::wait_read,
                   [this, wait = waits_.begin()](const std::error_code& error) {
                     if (!wait.current()) return;
                     waiting_ = false;
                     if (error) {
                       fail(error.value());
                     } else {
                       read();
                     }
                   });
}

void PipeReader::fail(int error_number) {
  events_.on_failure(unreadable_now(path_, error_number));
  events_.on_end();
}

void PipeReader::read() {
  const ssize_t got = ::read(pipe_.native_handle(), chunk_.data(), chunk_.size());
  if (got > 0) {
    events_.on_bytes({chunk_.data(), static_cast<std::size_t>(got)});
  } else if (got == 0) {
    events_.on_end();
    return;
  } else if (errno != EAGAIN && errno != EINTR) {
    fail(errno);
    return;
  }
  await();
}

}  // namespace aucast::server
