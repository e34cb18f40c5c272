#include "server/voice/voice_tracks.h"

#include <sys/resource.h>

#include <algorithm>
#include <system_error>

#include <asio/post.hpp>

#include "common/log.h"
#include "common/text.h"

namespace aucast::server {
namespace {

/// What is read of a file before the next one's turn, in VoiceReader::read()s of two seconds.
constexpr int kReadsInTurn = 10;
/// Serving comes first: who is served waits for no encoder.
constexpr int kNiceness = 10;

}  // namespace

VoiceTracks::VoiceTracks(asio::io_context& io, const voice::VoiceSettings& settings,
                         std::function<void()> on_grown)
    : io_(io), settings_(settings), on_grown_(std::move(on_grown)) {}

VoiceTracks::~VoiceTracks() {
  stop();
  if (thread_.joinable()) thread_.join();
}

std::shared_ptr<const protocol::EncodedTrack> VoiceTracks::track_of(const VoiceFile& file) {
  std::erase_if(tracks_, [](const auto& entry) { return entry.second.expired(); });
  for (const auto& [known, held] : tracks_) {
    if (auto track = held.lock(); track && known == file) return track;
  }
  auto track = std::make_shared<protocol::EncodedTrack>();
  tracks_.emplace_back(file, track);
  const std::lock_guard lock(mutex_);
  if (stopped_) return track;
  jobs_.push_back({file, track, std::nullopt});
  changed_.notify_one();
  if (thread_.joinable()) return track;
  // Thrown when the system has no thread left.
  try {
    thread_ = std::thread([this] { encode_until_stopped(); });
  } catch (const std::system_error& failure) {
    spdlog::error(
        "{}", at_place(file.path.string(), "its voice is not served: " + shortage_text(failure)));
    jobs_.clear();
    track->finish();
  }
  return track;
}

bool VoiceTracks::running() const {
  const std::lock_guard lock(mutex_);
  return encoding_;
}

bool VoiceTracks::stopped() const {
  const std::lock_guard lock(mutex_);
  return stopped_;
}

void VoiceTracks::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  changed_.notify_one();
}

void VoiceTracks::encode_until_stopped() {
  static_cast<void>(::setpriority(PRIO_PROCESS, 0, kNiceness));  // of this thread, on Linux
  std::unique_lock lock(mutex_);
  while (!stopped_) {
    changed_.wait(lock, [this] { return stopped_ || !jobs_.empty(); });
    if (stopped_) return;
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    encoding_ = true;
    lock.unlock();
    bool more = true;
    for (int i = 0; more && i < kReadsInTurn && !stopped(); ++i) more = encode_some(job);
    lock.lock();
    encoding_ = false;
    if (more) jobs_.push_back(std::move(job));
  }
}

bool VoiceTracks::encode_some(Job& job) {
  if (job.track.expired()) return false;
  std::vector<protocol::VoicePacket> packets;
  if (!job.reader) {
    auto opened = VoiceReader::open(job.file, settings_);
    if (!opened) {
      spdlog::error("{}; the face is served without it", opened.error().message);
      deliver(job, {}, true);
      return false;
    }
    job.reader = std::move(*opened);
  }
  const bool more = job.reader->read(packets);
  if (!more && !job.reader->complaint().empty()) spdlog::warn("{}", job.reader->complaint());
  deliver(job, std::move(packets), !more);
  return more;
}

void VoiceTracks::deliver(const Job& job, std::vector<protocol::VoicePacket> packets, bool last) {
  // What is not a whole packet yet begins before the end of what was read.
  const Milliseconds known =
      job.reader ? std::max(job.reader->end() - settings_.frame, Milliseconds::zero())
                 : Milliseconds::zero();
  asio::post(
      io_, [held = job.track, on_grown = on_grown_, known, last, read = job.reader.has_value(),
            path = job.file.path.string(), packets = std::move(packets)] {
        const auto track = held.lock();
        if (!track) return;
        for (const protocol::VoicePacket& packet : packets) track->add(packet);
        track->encoded_to(known);
        if (last) {
          track->finish();
          if (read)
            spdlog::info("{}: its voice is there, {} packets", path, track->packets().size());
        }
        on_grown();
      });
}

}  // namespace aucast::server
