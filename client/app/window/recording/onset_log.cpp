#include "client/app/window/recording/onset_log.h"

#include <array>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "common/files.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::app {

Result<std::unique_ptr<OnsetLog>> OnsetLog::create(const std::filesystem::path& path) {
  auto temporary = create_temporary_beside(path);
  if (!temporary) return temporary.error();
  return std::unique_ptr<OnsetLog>(new OnsetLog(path, *std::move(temporary)));
}

OnsetLog::OnsetLog(std::filesystem::path path, std::filesystem::path temporary)
    : path_(std::move(path)), temporary_(std::move(temporary)), rows_(temporary_) {
  rows_ << "monotonic_s,keyframe,aus\n";
}

OnsetLog::~OnsetLog() {
  if (finished_) return;
  if (const auto finished = finish(); !finished) spdlog::warn("{}", finished.error().message);
}

void OnsetLog::add(Instant shown, std::uint64_t keyframe, const std::optional<AuFrame>& aus) {
  std::array<char, 40> time{};
  std::snprintf(time.data(), time.size(), "%.6f", seconds(shown.time_since_epoch()));
  rows_ << time.data() << ',' << keyframe << ",\""
        << (aus ? protocol::format_au_set(*aus) : std::string()) << "\"\n";
}

Result<void> OnsetLog::finish() {
  finished_ = true;
  rows_.close();
  if (rows_.fail()) {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    return Error{ErrorKind::Failed,
                 at_place(path_.string(), "the onsets could not be written; is the disk full?")};
  }
  return replace_file(temporary_, path_);
}

}  // namespace aucast::app
