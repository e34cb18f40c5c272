#include "server/voice/voice_tracks.h"

#include <sys/resource.h>

#include <algorithm>
#include <utility>

#include "common/log.h"
#include "common/text.h"
#include "common/thread.h"

namespace aucast::server {
namespace {

/// How much of a file is read before the next one's turn, in calls of VoiceReader::read(), which
/// are two seconds each.
constexpr int kReadsInTurn = 10;
/// Serving comes first: no client waits for the encoder.
constexpr int kNiceness = 10;

}  // namespace

VoiceTracks::VoiceTracks(asio::io_context& io, const voice::VoiceSettings& settings,
                         std::function<void()> on_grown)
    : settings_(settings),
      on_grown_(std::move(on_grown)),
      gate_(std::make_shared<link::LoopGate>(io)) {}

std::shared_ptr<const protocol::EncodedTrack> VoiceTracks::track_of(const VoiceFile& file) {
  std::erase_if(tracks_, [](const auto& entry) { return entry.second.expired(); });
  for (const auto& [known, held] : tracks_) {
    if (auto track = held.lock(); track && known == file) return track;
  }
  auto track = std::make_shared<protocol::EncodedTrack>();
  tracks_.emplace_back(file, track);
  if (stopped_) return track;
  jobs_.change([&](std::deque<Job>& jobs) { jobs.push_back({file, track, std::nullopt}); });
  if (thread_.joinable()) return track;
  if (auto started =
          start_thread([this](const std::stop_token& stop) { encode_until_stopped(stop); })) {
    thread_ = std::move(*started);
  } else {
    spdlog::error(
        "{}", at_place(file.path.string(), "its voice is not served: " + started.error().message));
    jobs_.with([](std::deque<Job>& jobs) { jobs.clear(); });
    track->finish();
  }
  return track;
}

void VoiceTracks::stop() {
  stopped_ = true;
  thread_.request_stop();
}

void VoiceTracks::encode_until_stopped(const std::stop_token& stop) {
  static_cast<void>(::setpriority(PRIO_PROCESS, 0, kNiceness));  // of this thread, on Linux
  const auto something = [](const std::deque<Job>& jobs) { return !jobs.empty(); };
  const auto take = [&stop](std::deque<Job>& jobs) -> std::optional<Job> {
    if (stop.stop_requested()) return std::nullopt;
    Job job = std::move(jobs.front());
    jobs.pop_front();
    return job;
  };
  while (auto job = jobs_.wait(stop, something, take)) {
    bool more = true;
    for (int i = 0; more && i < kReadsInTurn && !stop.stop_requested(); ++i) {
      more = encode_some(*job);
    }
    if (!more) continue;
    jobs_.with([&](std::deque<Job>& jobs) { jobs.push_back(std::move(*job)); });
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
  // Waits, so that a fast encoder does not fill the memory with packets while the loop is busy.
  gate_->post_and_wait([this, held = job.track, known, last, read = job.reader.has_value(),
                        path = job.file.path.string(), packets = std::move(packets)] {
    const auto track = held.lock();
    if (!track) return;
    for (const protocol::VoicePacket& packet : packets) track->add(packet);
    track->encoded_to(known);
    if (last) {
      track->finish();
      if (read) spdlog::info("{}: its voice is there, {} packets", path, track->packets().size());
    }
    on_grown_();
  });
}

}  // namespace aucast::server
