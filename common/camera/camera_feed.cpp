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
#include "common/mesh/neutral_face.h"
#include "common/mesh/read_aus.h"
#include "common/mesh/sob_watch.h"
#include "common/mesh/steady_gaze.h"
#include "common/text.h"
#include "common/thread.h"
#include "common/time.h"

namespace aucast::camera {
namespace {

double now_seconds() {
  return seconds(std::chrono::steady_clock::now().time_since_epoch());
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
                                                      const FaceOptions& faces, OnSight on_sight,
                                                      const GivenUp& given_up) {
  auto models = load_face_models();
  if (!models) return models.error();
  auto pictures = PictureSource::open_camera(options, given_up);
  if (!pictures) return pictures.error();
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    return Error{ErrorKind::Failed,
                 at_place(options.device, "cannot be read: " + system_reason(errno))};
  }
  std::unique_ptr<CameraFeed> feed(new CameraFeed(std::move(*pictures), std::move(*models), faces,
                                                  std::move(on_sight), Descriptor(ends[0]),
                                                  Descriptor(ends[1])));
  // What began ends with the feed.
  auto taking = start_thread([&feed = *feed] { feed.take_pictures(); });
  if (!taking) return Error{ErrorKind::Failed, at_place(options.device, taking.error().message)};
  feed->taking_ = std::move(*taking);
  auto reading = start_thread([&feed = *feed] { feed.read_faces(); });
  if (!reading) return Error{ErrorKind::Failed, at_place(options.device, reading.error().message)};
  feed->reading_ = std::move(*reading);
  return feed;
}

CameraFeed::CameraFeed(PictureSource pictures, FaceModels models, const FaceOptions& faces,
                       OnSight on_sight, Descriptor rows, Descriptor write)
    : pictures_(std::move(pictures)),
      models_(std::move(models)),
      faces_(faces),
      on_sight_(std::move(on_sight)),
      rows_(std::move(rows)),
      write_(std::move(write)) {}

CameraFeed::~CameraFeed() {
  seen_.change([](Seen& seen) { seen.ended = true; });
  if (taking_.joinable()) {
    pictures_.stop();
    taking_.join();
  }
  if (reading_.joinable()) reading_.join();
}

std::string CameraFeed::complaint() const {
  return seen_.with([](const Seen& seen) { return seen.complaint; });
}

std::uint64_t CameraFeed::rows_left_out() const {
  return seen_.with([](const Seen& seen) { return seen.rows_left_out; });
}

void CameraFeed::take_pictures() {
  TimedPicture picture;
  while (pictures_.next(picture.rgb)) {
    picture.seconds = now_seconds();
    const bool ended = seen_.change([&picture](Seen& seen) {
      if (seen.ended) return true;
      if (!seen.newest) seen.newest = TimedPicture{};
      std::swap(*seen.newest, picture);
      return false;
    });
    if (ended) return;
  }
  // Waited for here, so that it is known when the rows end.
  std::string complaint = pictures_.complaint();
  seen_.change([&complaint](Seen& seen) {
    seen.complaint = std::move(complaint);
    seen.ended = true;
  });
}

bool CameraFeed::write(const std::string& text) {
  // A row is shorter than what a pipe takes whole or not at all. One that finds no room is late.
  if (::write(write_.get(), text.data(), text.size()) >= 0) return true;
  if (errno != EAGAIN && errno != EINTR) return false;
  seen_.with([](Seen& seen) { ++seen.rows_left_out; });
  return true;
}

std::vector<mesh::SeenFace> CameraFeed::look_at(const mesh::Picture& picture) {
  if (faces_.several) return models_.tracker.follow_all(picture);
  std::vector<mesh::SeenFace> seen;
  if (auto face = models_.tracker.follow(picture)) seen.push_back({0, *std::move(face)});
  return seen;
}

void CameraFeed::read_faces() {
  block_pipe_signal();
  const FaceTable table(models_.weights, faces_.several);
  const bool typical = faces_.neutral_seconds && *faces_.neutral_seconds == 0;
  struct Watched {
    mesh::RunningNeutralFace neutral;
    mesh::RunningSteadyGaze gaze{};
    mesh::SobWatch sobs{};
  };
  std::vector<Watched> watched;  // by the face's number
  bool going = write(table.header());
  const std::size_t width = pictures_.format().width();
  const std::size_t height = pictures_.format().height();
  while (going) {
    const auto newest =
        seen_.wait([](const Seen& seen) { return seen.newest || seen.ended; },
                   [](Seen& seen) { return std::exchange(seen.newest, std::nullopt); });
    if (!newest) break;
    const TimedPicture& picture = *newest;
    const std::vector<mesh::SeenFace> seen = look_at({width, height, picture.rgb});
    Sight sight{{width, height, picture.rgb}, nullptr, {}};
    if (seen.empty()) going = write(table.row(picture.seconds, 0, std::nullopt));
    for (const auto& [number, landmarks] : seen) {
      while (watched.size() <= number) {
        watched.push_back({mesh::RunningNeutralFace(models_.weights)});
      }
      auto& [neutral, gaze, sobs] = watched[number];
      const auto measures =
          gaze.watch(mesh::measure(mesh::fit_head(landmarks, mesh::kTypicalStillPoints)));
      AuFrame face = mesh::read_aus(
          models_.weights, measures,
          typical ? models_.weights.typical : neutral.watch(picture.seconds, measures));
      sobs.watch(picture.seconds, face);
      going = write(table.row(picture.seconds, landmarks.presence, face, number)) && going;
      if (sight.landmarks != nullptr) continue;
      sight.landmarks = &landmarks;
      sight.aus = table.terms(face);
    }
    if (on_sight_) on_sight_(sight);
  }
  // Nobody may read the rows any more: then no picture is wanted either.
  seen_.change([](Seen& seen) { seen.ended = true; });
  write_ = Descriptor();  // the reader of the rows sees their end
}

}  // namespace aucast::camera
