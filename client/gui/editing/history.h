#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace aucast::gui {

/// A state and the steps that led to it, which can be undone and redone.
template <typename State>
class History {
 public:
  /// Keeps the last `steps_max` steps.
  explicit History(std::size_t steps_max) : steps_max_(steps_max) {}

  [[nodiscard]] const State& now() const { return now_; }
  /// For a change that is not a step.
  [[nodiscard]] State& now() { return now_; }
  [[nodiscard]] bool can_undo() const { return !past_.empty(); }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }

  /// `continued`: the change belongs to the previous step, like the many values of one drag.
  void step(State next, bool continued = false) {
    future_.clear();
    if (continued && !past_.empty()) {
      now_ = std::move(next);
      return;
    }
    if (past_.size() == steps_max_) past_.erase(past_.begin());
    past_.push_back(std::exchange(now_, std::move(next)));
  }
  /// Returns false if there is no step to undo.
  bool undo() { return turn(past_, future_); }
  /// Returns false if there is no step to redo.
  bool redo() { return turn(future_, past_); }

  /// Calls `change` with every state except the present one.
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
