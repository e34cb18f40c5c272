#include "client/app/window/recording/onset_log.h"

#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "common/log.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::app {

OnsetLog::~OnsetLog() {
  if (const auto ended = end(); !ended) spdlog::warn("{}", ended.error().message);
}

Result<void> OnsetLog::begin(const std::filesystem::path& file) {
  if (auto ended = end(); !ended) return ended;
  auto temporary = TemporaryFile::beside(file);
  if (!temporary) return temporary.error();
  file_ = file;
  temporary_ = *std::move(temporary);
  rows_ = std::ofstream(temporary_.path());
  rows_ << "monotonic_s,keyframe,aus,reached\n";
  reached_.reset();
  return {};
}

void OnsetLog::add(Instant shown, const FaceShown& face) {
  if (file_.empty()) return;
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

Result<void> OnsetLog::end() {
  if (file_.empty()) return {};
  const std::filesystem::path file = std::exchange(file_, {});
  rows_.close();
  if (rows_.fail()) {
    temporary_.remove();
    return Error{ErrorKind::Failed,
                 at_place(file.string(), "the onsets could not be written; is the disk full?")};
  }
  return temporary_.replace(file);
}

}  // namespace aucast::app
