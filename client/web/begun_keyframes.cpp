#include "client/web/begun_keyframes.h"

#include <iterator>
#include <utility>

namespace aucast::web {

void BegunKeyframes::add(Begun keyframe) {
  if (ahead_.size() == kMax) ahead_.pop_front();
  ahead_.push_back(std::move(keyframe));
}

std::optional<AuFrame> BegunKeyframes::pass(Instant heard) {
  std::optional<AuFrame> aus;
  for (; !ahead_.empty() && ahead_.front().at <= heard; ahead_.pop_front()) {
    aus = std::move(ahead_.front().aus);
    if (lines_.size() == kMax) lines_.pop_front();
    lines_.push_back(std::move(ahead_.front().line));
  }
  return aus;
}

std::vector<std::string> BegunKeyframes::take_lines() {
  std::vector<std::string> lines(std::make_move_iterator(lines_.begin()),
                                 std::make_move_iterator(lines_.end()));
  lines_.clear();
  return lines;
}

}  // namespace aucast::web
