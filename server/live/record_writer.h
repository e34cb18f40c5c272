#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "common/result.h"
#include "common/shared.h"
#include "server/live/record_file.h"

namespace aucast::server {

/// Writes a record on a thread of its own, so that a slow disk delays no client. A full disk ends
/// the recording, but not the stream.
/// Thread: its owner's; the Shared part is also used by the writing thread.
class RecordWriter {
 public:
  /// Each waiting piece counts as this many bytes more than its data: about the memory that the
  /// piece itself takes.
  static constexpr std::size_t kBytesEach = 128;

  /// Errors are those of RecordFile::create().
  [[nodiscard]] static Result<std::unique_ptr<RecordWriter>> start(
      const std::filesystem::path& path, const RecordForm& form);
  RecordWriter(std::filesystem::path path, RecordFile file);
  ~RecordWriter();
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

  /// Adds successive pieces; each is written whole or not at all.
  void add(std::vector<std::string> pieces);
  /// Adds what `make` returns, which may be empty. `make` runs on the writing thread, in its turn,
  /// before finish() returns; after the recording has ended, it is not run. `bytes`: how many bytes
  /// `make` holds until it runs. Only these, and kBytesEach, count as waiting for the disk; `make`
  /// may return any number of bytes.
  void add(std::size_t bytes, std::function<std::string()> make);
  /// Waits until everything is written. Fails with the error that ended the recording, if any.
  [[nodiscard]] Result<void> finish();
  /// How many pieces are in the file. Call it after finish().
  [[nodiscard]] std::size_t written() const { return written_; }

 private:
  using Makers = std::vector<std::function<std::string()>>;
  struct Pieces {
    Makers waiting;                   ///< of what is to be written
    std::size_t unwritten_bytes = 0;  ///< of these, and of those that are being written
    std::optional<Error> error;       ///< what ended the recording
  };

  void enqueue(std::size_t bytes, Makers makers);
  void end_with(const Error& why);
  /// After `stop` it still writes what waits.
  void write_until_finished(const std::stop_token& stop);
  [[nodiscard]] Result<void> write(const Makers& makers);

  std::filesystem::path path_;
  RecordFile file_;          ///< of the writing thread
  std::size_t written_ = 0;  ///< of the writing thread
  Shared<Pieces> pieces_;
  std::jthread thread_;
};

}  // namespace aucast::server
