#include "client/app/window/recording/onset_session.h"

#include <utility>

namespace aucast::app {

Result<void> OnsetSession::begin(const std::filesystem::path& file) {
  if (auto ended = end(); !ended) return ended;
  auto log = OnsetLog::create(file);
  if (!log) return log.error();
  log_ = *std::move(log);
  file_ = file.string();
  return {};
}

void OnsetSession::add(Instant shown, const FaceShown& face) {
  if (log_ != nullptr) log_->add(shown, face);
}

Result<void> OnsetSession::end() {
  if (log_ == nullptr) return {};
  auto finished = log_->finish();
  log_.reset();
  file_.clear();
  return finished;
}

}  // namespace aucast::app
