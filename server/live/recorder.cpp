#include "server/live/recorder.h"

#include <array>
#include <chrono>
#include <ctime>
#include <system_error>
#include <utility>

#include "common/log.h"
#include "common/text.h"
#include "protocol/stream_file.h"

namespace aucast::server {
namespace {

/// What a power cut may take.
constexpr std::chrono::seconds kSyncEvery{1};

/// A disk that takes nothing for so much, some ten minutes of a face, is none to record to.
constexpr std::size_t kWaitingBytesMost = std::size_t{1} << 20U;

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::start(const std::filesystem::path& path) {
  auto file = RecordFile::create(path);
  if (!file) return file.error();
  // Thrown when the system has no thread left.
  try {
    auto recorder = std::make_unique<Recorder>(path, std::move(*file));
    spdlog::info("recording to {}", path.string());
    return recorder;
  } catch (const std::system_error& failure) {
    return Error{ErrorKind::Failed,
                 escaped(path.string()) + ": cannot be recorded: " + failure.code().message()};
  }
}

Recorder::Recorder(std::filesystem::path path, RecordFile file)
    : path_(std::move(path)), file_(std::move(file)), thread_([this] { write_until_finished(); }) {}

Recorder::~Recorder() {
  static_cast<void>(finish());
}

void Recorder::add(const protocol::Keyframe& keyframe, double now, bool free) {
  std::string lines;
  for (const protocol::Keyframe& line : timeline_.add(keyframe, now, free)) {
    lines += protocol::format_stream_line(line) + '\n';
  }
  const std::lock_guard lock(mutex_);
  if (error_) return;
  if (waiting_.size() + lines.size() > kWaitingBytesMost) {
    error_ = Error{ErrorKind::Failed,
                   at_place(path_.string(), "cannot be written: the disk takes nothing")};
    spdlog::error("{}; the recording ends here, serving goes on", error_->message);
    return;
  }
  waiting_ += lines;
  changed_.notify_one();
}

Result<void> Recorder::finish() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
    changed_.notify_one();
  }
  if (thread_.joinable()) {
    thread_.join();
    spdlog::info("{} keyframes recorded to {}", written_, path_.string());
  }
  const std::lock_guard lock(mutex_);
  if (error_) return *error_;
  return {};
}

Result<void> Recorder::write(std::string_view lines) {
  // One by one: of what no longer fits on the disk, what does is kept.
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n') + 1;
    if (auto added = file_.add(lines.substr(0, end)); !added) return added;
    lines.remove_prefix(end);
    ++written_;
  }
  return {};
}

void Recorder::write_until_finished() {
  auto sync_at = std::chrono::steady_clock::time_point::max();
  std::unique_lock lock(mutex_);
  for (;;) {
    const auto something = [this] { return finished_ || !waiting_.empty(); };
    if (sync_at == std::chrono::steady_clock::time_point::max()) {
      changed_.wait(lock, something);
    } else {
      changed_.wait_until(lock, sync_at, something);
    }
    const bool last = finished_;
    const std::string lines = std::exchange(waiting_, {});
    lock.unlock();
    const auto now = std::chrono::steady_clock::now();
    Result<void> done;
    if (!lines.empty()) {
      done = write(lines);
      sync_at = std::min(sync_at, now + kSyncEvery);
    }
    if (done && (last || now >= sync_at)) {
      done = file_.sync();
      sync_at = std::chrono::steady_clock::time_point::max();
    }
    lock.lock();
    if (!done && !error_) {
      error_ = done.error();
      spdlog::error("{}; the recording ends here, serving goes on", error_->message);
    }
    if (last || error_) return;
  }
}

std::optional<std::filesystem::path> record_path(const std::filesystem::path& record,
                                                 const std::string& stream, bool first) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(record, ignored)) {
    return first ? std::optional(record) : std::nullopt;
  }
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> time{};
  const std::size_t length = std::strftime(time.data(), time.size(), "-%Y%m%dT%H%M%SZ", &parts);
  return record / (stream + std::string(time.data(), length) + ".txt");
}

}  // namespace aucast::server
