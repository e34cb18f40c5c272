#include "common/camera/camera_feed.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <utility>

#include "common/camera/face_table.h"
#include "common/mesh/quiet_face.h"
#include "common/mesh/read_aus.h"
#include "common/text.h"
#include "common/thread.h"

namespace aucast::camera {
namespace {

double now_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Writing to a pipe that nobody reads must not end the program.
void block_pipe_signal() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

}  // namespace

Result<std::unique_ptr<CameraFeed>> CameraFeed::start(const CameraOptions& options,
                                                      const QuietOptions& quiet, OnSight on_sight) {
  auto models = load_face_models();
  if (!models) return models.error();
  auto pictures = PictureSource::open_camera(options);
  if (!pictures) return pictures.error();
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    return Error{ErrorKind::Failed,
                 at_place(options.device, "cannot be read: " + system_reason(errno))};
  }
  std::unique_ptr<CameraFeed> feed(new CameraFeed(std::move(*pictures), std::move(*models), quiet,
                                                  std::move(on_sight), ends[0], ends[1]));
  // What began ends with the feed.
  auto taking = start_thread([&feed = *feed] { feed.take_pictures(); });
  if (!taking) return Error{ErrorKind::Failed, at_place(options.device, taking.error().message)};
  feed->taking_ = std::move(*taking);
  auto reading = start_thread([&feed = *feed] { feed.read_faces(); });
  if (!reading) return Error{ErrorKind::Failed, at_place(options.device, reading.error().message)};
  feed->reading_ = std::move(*reading);
  return feed;
}

CameraFeed::CameraFeed(PictureSource pictures, FaceModels models, const QuietOptions& quiet,
                       OnSight on_sight, int rows, int write)
    : pictures_(std::move(pictures)),
      models_(std::move(models)),
      quiet_(quiet),
      on_sight_(std::move(on_sight)),
      rows_(rows),
      write_(write) {}

CameraFeed::~CameraFeed() {
  seen_.change([](Pictures& seen) { seen.ended = true; });
  if (taking_.joinable()) {
    pictures_.stop();
    taking_.join();
  }
  if (reading_.joinable()) {
    reading_.join();
  } else {
    ::close(write_);
  }
  if (rows_ >= 0) ::close(rows_);
}

int CameraFeed::take_rows() {
  return std::exchange(rows_, -1);
}

std::string CameraFeed::complaint() {
  if (taking_.joinable()) taking_.join();
  return pictures_.complaint();
}

void CameraFeed::take_pictures() {
  Picture picture;
  while (pictures_.next(picture.rgb)) {
    picture.seconds = now_seconds();
    const bool ended = seen_.change([&picture](Pictures& seen) {
      if (seen.ended) return true;
      if (!seen.newest) seen.newest = Picture{};
      std::swap(*seen.newest, picture);
      return false;
    });
    if (ended) return;
  }
  seen_.change([](Pictures& seen) { seen.ended = true; });
}

bool CameraFeed::write(const std::string& text) const {
  // A row is shorter than what a pipe takes whole or not at all. One that finds no room is late.
  const ssize_t written = ::write(write_, text.data(), text.size());
  return written >= 0 || errno == EAGAIN || errno == EINTR;
}

void CameraFeed::read_faces() {
  block_pipe_signal();
  const FaceTable table(models_.weights);
  mesh::RunningQuietFace running(models_.weights);
  bool going = write(table.header());
  const std::size_t width = pictures_.format().width();
  const std::size_t height = pictures_.format().height();
  while (going) {
    const auto newest =
        seen_.wait([](const Pictures& seen) { return seen.newest || seen.ended; },
                   [](Pictures& seen) { return std::exchange(seen.newest, std::nullopt); });
    if (!newest) break;
    const Picture& picture = *newest;
    const auto seen = models_.tracker.follow({width, height, picture.rgb});
    std::optional<AuFrame> face;
    if (seen) {
      const auto measures = mesh::measure(mesh::fit_head(*seen, mesh::kTypicalStillPoints));
      const bool typical = quiet_.seconds && *quiet_.seconds == 0;
      face = mesh::read_aus(
          models_.weights, measures,
          typical ? models_.weights.typical : running.watch(picture.seconds, measures));
    }
    going = write(table.row(picture.seconds, seen ? seen->presence : 0, face));
    if (on_sight_) {
      on_sight_({{width, height, picture.rgb},
                 seen ? &*seen : nullptr,
                 face ? table.terms(*face) : std::vector<AuTerm>()});
    }
  }
  ::close(write_);  // the reader of the rows sees their end
}

}  // namespace aucast::camera
