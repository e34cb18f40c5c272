#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace aucast::gui {

/// A state and the steps that led to it, which can be undone and redone.
template <typename State>
class History {
 public:
  /// The bytes that a state takes besides what it shares with the next one.
  using Size = std::size_t (*)(const State& state, const State& next);

  /// Keeps the last `steps_max` steps; with `size`, fewer if they take more than `bytes_max`, but
  /// always the last one.
  explicit History(std::size_t steps_max, std::size_t bytes_max = 0, Size size = nullptr)
      : steps_max_(steps_max), bytes_max_(bytes_max), size_(size) {}

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
    past_.push_back(std::exchange(now_, std::move(next)));
    forget_oldest();
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
  void forget_oldest() {
    std::size_t kept = 0;
    std::size_t bytes = 0;
    const State* next = &now_;
    for (auto state = past_.rbegin(); state != past_.rend() && kept < steps_max_; ++state) {
      if (size_ != nullptr) bytes += size_(*state, *next);
      if (kept > 0 && bytes > bytes_max_) break;
      next = &*state;
      ++kept;
    }
    past_.erase(past_.begin(), past_.end() - static_cast<std::ptrdiff_t>(kept));
  }

  bool turn(std::vector<State>& from, std::vector<State>& to) {
    if (from.empty()) return false;
    to.push_back(std::exchange(now_, std::move(from.back())));
    from.pop_back();
    return true;
  }

  std::size_t steps_max_;
  std::size_t bytes_max_;
  Size size_;
  State now_{};
  std::vector<State> past_;
  std::vector<State> future_;
};

}  // namespace aucast::gui
