#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "client/sound/sound_track.h"
#include "common/result.h"
#include "common/shared.h"
#include "common/task.h"

namespace aucast::voice {
class SoundFile;
}

namespace aucast::sound {

/// A sound file as the track of a stream that is available whole. It is kept decoded: 115 MB for
/// an hour. Thread: the player's; begin() starts another one.
class FileTrack final : public SoundTrack {
 public:
  /// A file that lasts longer by its header is refused; of one whose header told of less, the rest
  /// is not played, which is a complaint.
  static constexpr int kHoursMax = 4;

  /// Reads the file to its end, or until `stop`, which is asked before each second of sound,
  /// returns true. Unreadable or BadData as voice::SoundFile, BadData if the file is too long.
  [[nodiscard]] static Result<std::unique_ptr<FileTrack>> open(
      const std::filesystem::path& path, const std::function<bool()>& stop = [] { return false; });
  /// Reads the first second, and the rest on a thread of its own, many times faster than it is
  /// played. What has not been read yet is silent. Errors as open(), or Failed when the system has
  /// no thread left.
  [[nodiscard]] static Result<std::unique_ptr<FileTrack>> begin(const std::filesystem::path& path);
  /// Waits for the thread, which reads no more than a second on.
  ~FileTrack() override;

  /// What is wrong with the file, once, when it has been read to its end; otherwise empty.
  [[nodiscard]] std::string take_complaint();

  void read(std::int64_t begin, std::span<float> samples) override;
  /// As of the last read(), where the file is still being read.
  [[nodiscard]] std::int64_t end() const override;

 private:
  /// A second of the file; only the last one may be shorter.
  using Block = std::vector<std::int16_t>;
  explicit FileTrack(std::filesystem::path path) : path_(std::move(path)) {}
  [[nodiscard]] bool read_block(voice::SoundFile& file);
  [[nodiscard]] std::string read_rest(voice::SoundFile& file, const std::function<bool()>& stop);
  void take_news();
  void append(Block block);
  [[nodiscard]] float at(std::int64_t sample) const;

  const std::filesystem::path path_;
  std::vector<Block> blocks_;
  std::int64_t count_ = 0;  ///< samples in blocks_
  std::string complaint_;
  Shared<std::vector<Block>> news_;  ///< what has been read, and was not taken yet
  std::stop_source stop_;
  Task<std::string> reading_;  ///< gives the complaint; the last member, since it uses the others
};

}  // namespace aucast::sound
