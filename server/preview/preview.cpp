#include "server/preview/preview.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include <asio/buffer.hpp>
#include <asio/write.hpp>

#include "common/descriptor.h"
#include "common/preview/orders.h"
#include "common/preview/preview_writer.h"
#include "common/text.h"

namespace aucast::server {
namespace {

constexpr std::size_t kReadBytes = 512;
/// The longest order.
constexpr std::size_t kOrderBytesMax = 512;
/// Enough for a picture and the answers to many orders.
constexpr std::size_t kWaitingBytesMax = std::size_t{1} << 20;

/// Takes a copy of the descriptor, since closing ours must not close the original.
Result<void> take_stream(int descriptor, const char* name, asio::posix::stream_descriptor& stream) {
  struct stat status {};
  const bool can =
      ::fstat(descriptor, &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
  Descriptor copy(can ? ::fcntl(descriptor, F_DUPFD_CLOEXEC, 3) : -1);
  if (copy.open() && copy.hand_to(stream)) return {};
  return Error{ErrorKind::Failed, std::string("--preview talks to the program that started it: ") +
                                      name + " is not a pipe or a socket"};
}

preview::Seen seen_of(const camera::Sight& sight) {
  const mesh::Picture& picture = sight.picture;
  preview::Seen seen = preview::small_picture(picture.width, picture.height, picture.rgb);
  seen.aus = sight.aus;
  if (sight.landmarks == nullptr) return seen;
  for (const mesh::Point& point : sight.landmarks->points) {
    seen.points.push_back({static_cast<float>(point.x / static_cast<double>(picture.width)),
                           static_cast<float>(point.y / static_cast<double>(picture.height))});
  }
  return seen;
}

}  // namespace

Preview::Preview(asio::io_context& io, Hooks hooks)
    : gate_(std::make_shared<link::LoopGate>(io)),
      hooks_(std::move(hooks)),
      in_(io),
      out_(io),
      chunk_(kReadBytes, '\0') {}

Result<void> Preview::start(int in, int out) {
  if (auto taken = take_stream(in, "standard input", in_); !taken) return taken;
  if (auto taken = take_stream(out, "standard output", out_); !taken) return taken;
  read();
  return {};
}

void Preview::stop() {
  gone_ = true;
  std::error_code ignored;
  in_.close(ignored);
  out_.close(ignored);
}

void Preview::offer(const camera::Sight& sight) {
  if (picture_pending_.with([](bool& pending) { return std::exchange(pending, true); })) return;
  gate_->post([this, record = preview::seen_record(seen_of(sight))] {
    const std::size_t watching = hooks_.watching();
    if (std::exchange(said_watching_, watching) != watching) {
      write(preview::watching_record(watching));
    }
    picture_in_waiting_ = true;
    write(record);
  });
}

void Preview::read() {
  in_.async_read_some(asio::buffer(chunk_), [this](const std::error_code& error, std::size_t got) {
    if (gone_) return;
    if (error) return end();
    orders_.append(chunk_, 0, got);
    take_orders();
    if (!gone_) read();
  });
}

void Preview::take_orders() {
  for (std::size_t end = 0; !gone_ && (end = orders_.find('\n')) != std::string::npos;) {
    const std::string line = orders_.substr(0, end);
    orders_.erase(0, end + 1);
    carry_out(line);
  }
  if (!gone_ && orders_.size() > kOrderBytesMax) end();
}

void Preview::carry_out(std::string_view line) {
  const auto order = preview::parse_order(line);
  if (!order) {
    write(preview::refused_record("'" + escaped(line) + "' is no order"));
  } else if (const auto* live = std::get_if<preview::GoLive>(&*order)) {
    const auto opened = hooks_.open(live->bind, live->port);
    // Where it cannot be opened anew nobody is let in.
    write(opened ? preview::live_record(*opened)
                 : preview::private_record() + preview::refused_record(opened.error().message));
  } else {
    hooks_.close();
    write(preview::private_record());
  }
}

void Preview::write(const std::string& record) {
  if (gone_) return;
  waiting_ += record;
  // Whoever gives orders and reads no answers has gone.
  if (waiting_.size() > kWaitingBytesMax) return end();
  write_on();
}

void Preview::write_on() {
  if (gone_ || !written_.empty() || waiting_.empty()) return;
  std::swap(written_, waiting_);
  const bool picture = std::exchange(picture_in_waiting_, false);
  asio::async_write(out_, asio::buffer(written_),
                    [this, picture](const std::error_code& error, std::size_t) {
                      if (gone_) return;
                      if (error) return end();
                      written_.clear();
                      if (picture) picture_pending_.with([](bool& pending) { pending = false; });
                      write_on();
                    });
}

void Preview::end() {
  stop();
  hooks_.on_gone();
}

}  // namespace aucast::server
