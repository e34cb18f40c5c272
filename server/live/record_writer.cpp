#include "server/live/record_writer.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "common/log.h"
#include "common/text.h"
#include "common/thread.h"
#include "common/time.h"

namespace aucast::server {
namespace {

/// How much time of a record a power cut may destroy.
constexpr std::chrono::seconds kSyncEvery{1};

/// The most that may wait for the disk, some minutes of a face; beyond that recording ends.
constexpr std::size_t kUnwrittenBytesMax = std::size_t{1} << 20U;

}  // namespace

Result<std::unique_ptr<RecordWriter>> RecordWriter::start(const std::filesystem::path& path,
                                                          const RecordForm& form) {
  auto file = RecordFile::create(path, form);
  if (!file) return file.error();
  auto writer = std::make_unique<RecordWriter>(path, std::move(*file));
  auto started = start_thread(
      [&writer = *writer](const std::stop_token& stop) { writer.write_until_finished(stop); });
  if (!started) {
    return Error{ErrorKind::Failed,
                 at_place(path.string(), "cannot be recorded to: " + started.error().message)};
  }
  writer->thread_ = std::move(*started);
  spdlog::info("recording to {}", path.string());
  return writer;
}

RecordWriter::RecordWriter(std::filesystem::path path, RecordFile file)
    : path_(std::move(path)), file_(std::move(file)) {}

RecordWriter::~RecordWriter() {
  static_cast<void>(finish());
}

void RecordWriter::add(std::vector<std::string> pieces) {
  if (pieces.empty()) return;
  std::size_t bytes = pieces.size() * kBytesEach;
  Makers makers;
  for (std::string& piece : pieces) {
    bytes += piece.size();
    makers.emplace_back([piece = std::move(piece)] { return piece; });
  }
  enqueue(bytes, std::move(makers));
}

void RecordWriter::add(std::size_t bytes, std::function<std::string()> make) {
  Makers makers;
  makers.push_back(std::move(make));
  enqueue(bytes + kBytesEach, std::move(makers));
}

void RecordWriter::enqueue(std::size_t bytes, Makers makers) {
  const bool full = pieces_.change([&](Pieces& shared) {
    if (shared.error) return false;
    // What was accepted is still written.
    if (shared.unwritten_bytes + bytes > kUnwrittenBytesMax) return true;
    shared.unwritten_bytes += bytes;
    shared.waiting.insert(shared.waiting.end(), std::make_move_iterator(makers.begin()),
                          std::make_move_iterator(makers.end()));
    return false;
  });
  if (full) {
    end_with({ErrorKind::Failed,
              at_place(path_.string(),
                       "cannot be written: the disk takes nothing; record to a faster one")});
  }
}

Result<void> RecordWriter::finish() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  return pieces_.with([](const Pieces& shared) {
    return shared.error ? Result<void>(*shared.error) : Result<void>();
  });
}

/// It is logged outside the lock: a log may wait for the same disk.
void RecordWriter::end_with(const Error& why) {
  const bool first = pieces_.change([&](Pieces& shared) {
    if (shared.error) return false;
    shared.error = why;
    return true;
  });
  if (first) spdlog::error("{}; the recording ends here, serving goes on", why.message);
}

/// Writes pieces one by one, so that those that still fit on the disk are kept.
Result<void> RecordWriter::write(const Makers& makers) {
  for (const auto& make : makers) {
    const std::string piece = make();
    if (piece.empty()) continue;
    if (auto added = file_.add(piece); !added) return added;
    ++written_;
  }
  return {};
}

void RecordWriter::write_until_finished(const std::stop_token& stop) {
  const auto something = [](const Pieces& shared) {
    return shared.error || !shared.waiting.empty();
  };
  bool last = false;
  std::size_t taken_bytes = 0;
  const auto take = [&](Pieces& shared) {
    last = stop.stop_requested() || shared.error;
    taken_bytes = shared.unwritten_bytes;
    return std::exchange(shared.waiting, {});
  };
  Instant sync_at = Instant::max();
  while (!last) {
    const Makers makers = sync_at == Instant::max()
                              ? pieces_.wait(stop, something, take)
                              : pieces_.wait_until(stop, sync_at, something, take);
    const Instant now = std::chrono::steady_clock::now();
    Result<void> done;
    if (!makers.empty()) {
      done = write(makers);
      pieces_.change([taken_bytes](Pieces& shared) { shared.unwritten_bytes -= taken_bytes; });
      sync_at = std::min<Instant>(sync_at, now + kSyncEvery);
    }
    if (done && (last || now >= sync_at)) {
      done = file_.sync();
      sync_at = Instant::max();
    }
    if (!done) {
      end_with(done.error());
      return;
    }
  }
}

}  // namespace aucast::server
