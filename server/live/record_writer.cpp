#include "server/live/record_writer.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <system_error>
#include <utility>

#include "common/log.h"
#include "common/text.h"

namespace aucast::server {
namespace {

/// What a power cut may take.
constexpr std::chrono::seconds kSyncEvery{1};

/// A disk that takes nothing for so much, some ten minutes of a face, is none to record to.
constexpr std::size_t kUnwrittenBytesMax = std::size_t{1} << 20U;

}  // namespace

Result<std::unique_ptr<RecordWriter>> RecordWriter::start(const std::filesystem::path& path,
                                                          const RecordForm& form) {
  auto file = RecordFile::create(path, form);
  if (!file) return file.error();
  // Thrown when the system has no thread left.
  try {
    auto writer = std::make_unique<RecordWriter>(path, std::move(*file));
    spdlog::info("recording to {}", path.string());
    return writer;
  } catch (const std::system_error& failure) {
    return Error{ErrorKind::Failed,
                 at_place(path.string(), "cannot be recorded to: " + shortage_text(failure))};
  }
}

RecordWriter::RecordWriter(std::filesystem::path path, RecordFile file)
    : path_(std::move(path)), file_(std::move(file)), thread_([this] { write_until_finished(); }) {}

RecordWriter::~RecordWriter() {
  static_cast<void>(finish());
}

void RecordWriter::add(std::vector<std::string> pieces) {
  if (pieces.empty()) return;
  std::size_t bytes = 0;
  for (const std::string& piece : pieces) bytes += piece.size();
  const std::lock_guard lock(mutex_);
  if (error_) return;
  if (waiting_bytes_ + bytes > kUnwrittenBytesMax) {
    // What was accepted is still written.
    end_with(
        {ErrorKind::Failed, at_place(path_.string(), "cannot be written: the disk takes nothing")});
    changed_.notify_one();
    return;
  }
  waiting_bytes_ += bytes;
  waiting_.insert(waiting_.end(), std::make_move_iterator(pieces.begin()),
                  std::make_move_iterator(pieces.end()));
  changed_.notify_one();
}

Result<void> RecordWriter::finish() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
    changed_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
  const std::lock_guard lock(mutex_);
  if (error_) return *error_;
  return {};
}

/// Under mutex_.
void RecordWriter::end_with(const Error& error) {
  if (error_) return;
  error_ = error;
  spdlog::error("{}; the recording ends here, serving goes on", error.message);
}

/// One by one: of what no longer fits on the disk, what does is kept.
Result<void> RecordWriter::write(const std::vector<std::string>& pieces) {
  for (const std::string& piece : pieces) {
    if (auto added = file_.add(piece); !added) return added;
    ++written_;
  }
  return {};
}

void RecordWriter::write_until_finished() {
  auto sync_at = std::chrono::steady_clock::time_point::max();
  std::unique_lock lock(mutex_);
  for (;;) {
    const auto something = [this] { return finished_ || error_ || !waiting_.empty(); };
    if (sync_at == std::chrono::steady_clock::time_point::max()) {
      changed_.wait(lock, something);
    } else {
      changed_.wait_until(lock, sync_at, something);
    }
    const bool last = finished_ || error_;
    const std::vector<std::string> pieces = std::exchange(waiting_, {});
    waiting_bytes_ = 0;
    lock.unlock();
    const auto now = std::chrono::steady_clock::now();
    Result<void> done;
    if (!pieces.empty()) {
      done = write(pieces);
      sync_at = std::min(sync_at, now + kSyncEvery);
    }
    if (done && (last || now >= sync_at)) {
      done = file_.sync();
      sync_at = std::chrono::steady_clock::time_point::max();
    }
    lock.lock();
    if (!done) end_with(done.error());
    if (last || !done) return;
  }
}

}  // namespace aucast::server
