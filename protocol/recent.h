#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace aucast::protocol {

/// A queue of the latest things; old ones are dropped. Things are numbered from 0 in the order in
/// which they are added.
template <typename T>
class Recent {
 public:
  void push_back(T thing) { kept_.push_back(std::move(thing)); }
  void pop_front() {
    kept_.pop_front();
    ++dropped_;
  }
  [[nodiscard]] bool empty() const { return kept_.empty(); }
  [[nodiscard]] std::size_t size() const { return kept_.size(); }
  [[nodiscard]] const T& front() const { return kept_.front(); }
  [[nodiscard]] const T& back() const { return kept_.back(); }

  /// The number of the oldest thing that is kept.
  [[nodiscard]] std::uint64_t first_number() const { return dropped_; }
  /// The thing with this number; null: it was dropped, or was not added yet.
  [[nodiscard]] const T* find(std::uint64_t number) const {
    const bool kept = number >= dropped_ && number - dropped_ < kept_.size();
    return kept ? &kept_[static_cast<std::size_t>(number - dropped_)] : nullptr;
  }

 private:
  std::deque<T> kept_;
  std::uint64_t dropped_ = 0;
};

}  // namespace aucast::protocol
