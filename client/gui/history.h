#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace aucast::gui {

/// A state and the steps that led to it, which can be taken back and done again.
template <typename State>
class History {
 public:
  /// The oldest step goes when there are more than `steps_max`.
  explicit History(std::size_t steps_max) : steps_max_(steps_max) {}

  [[nodiscard]] const State& now() const { return now_; }
  /// For a change that is no step.
  [[nodiscard]] State& now() { return now_; }
  [[nodiscard]] bool can_undo() const { return !past_.empty(); }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }

  /// `continued`: this belongs to the step before, as the many values of one drag do.
  void step(State next, bool continued = false) {
    future_.clear();
    if (continued && !past_.empty()) {
      now_ = std::move(next);
      return;
    }
    if (past_.size() == steps_max_) past_.erase(past_.begin());
    past_.push_back(std::exchange(now_, std::move(next)));
  }
  /// False when there is no step to take back.
  bool undo() { return turn(past_, future_); }
  /// False when there is none to do again.
  bool redo() { return turn(future_, past_); }

  /// Calls `change` with every state but that of now.
  template <typename Change>
  void change_others(const Change& change) {
    for (std::vector<State>* states : {&past_, &future_}) {
      for (State& state : *states) change(state);
    }
  }

 private:
  bool turn(std::vector<State>& from, std::vector<State>& to) {
    if (from.empty()) return false;
    to.push_back(std::exchange(now_, std::move(from.back())));
    from.pop_back();
    return true;
  }

  std::size_t steps_max_;
  State now_{};
  std::vector<State> past_;
  std::vector<State> future_;
};

}  // namespace aucast::gui
