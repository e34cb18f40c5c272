#include "client/app/window/recording/onset_log.h"

#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "common/log.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::app {

Result<std::unique_ptr<OnsetLog>> OnsetLog::create(const std::filesystem::path& path) {
  auto temporary = TemporaryFile::beside(path);
  if (!temporary) return temporary.error();
  return std::unique_ptr<OnsetLog>(new OnsetLog(path, *std::move(temporary)));
}

OnsetLog::OnsetLog(std::filesystem::path path, TemporaryFile temporary)
    : path_(std::move(path)), temporary_(std::move(temporary)), rows_(temporary_.path()) {
  rows_ << "monotonic_s,keyframe,aus,reached\n";
}

OnsetLog::~OnsetLog() {
  if (finished_) return;
  if (const auto finished = finish(); !finished) spdlog::warn("{}", finished.error().message);
}

void OnsetLog::add(Instant shown, const FaceShown& face) {
  std::array<char, 40> time{};
  std::snprintf(time.data(), time.size(), "%.6f", seconds(shown.time_since_epoch()));
  rows_ << time.data() << ',' << face.keyframe << ",\""
        << (face.aus ? protocol::format_au_set(*face.aus) : std::string()) << "\",";
  if (face.keyframe != 0) {
    // Fewer than before: playing has gone back, or begun again.
    const std::uint64_t first = reached_.value_or(face.reached) + 1;
    if (face.reached > first) rows_ << first << '-';
    if (face.reached >= first) rows_ << face.reached;
    reached_ = face.reached;
  }
  rows_ << '\n';
}

Result<void> OnsetLog::finish() {
  finished_ = true;
  rows_.close();
  if (rows_.fail()) {
    temporary_.remove();
    return Error{ErrorKind::Failed,
                 at_place(path_.string(), "the onsets could not be written; is the disk full?")};
  }
  return temporary_.replace(path_);
}

}  // namespace aucast::app
