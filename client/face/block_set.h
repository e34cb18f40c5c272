#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aucast::face {

/// A set of blocks of vertices, one bit each. Sets that are combined or compared must have been
/// made for the same number of blocks.
class BlockSet {
 public:
  static constexpr std::size_t kWordBits = 64;

  /// The block's bit in its word.
  [[nodiscard]] static constexpr std::uint64_t bit(std::size_t block) {
    return std::uint64_t{1} << (block % kWordBits);
  }

  BlockSet() = default;
  explicit BlockSet(std::size_t block_count) : words_((block_count + kWordBits - 1) / kWordBits) {}

  void insert(std::size_t block) { words_[block / kWordBits] |= bit(block); }
  /// Inserts several blocks of one word: bit i stands for block kWordBits * word + i.
  void insert(std::size_t word, std::uint64_t bits) { words_[word] |= bits; }
  void clear() { std::fill(words_.begin(), words_.end(), std::uint64_t{0}); }

  bool operator==(const BlockSet&) const = default;

  BlockSet& operator|=(const BlockSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
  }

  /// Keeps the blocks that are in both.
  BlockSet& operator&=(const BlockSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  /// Removes the blocks that are in `other`.
  BlockSet& operator-=(const BlockSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~other.words_[i];
    return *this;
  }

  [[nodiscard]] bool contains(std::size_t block) const {
    return (words_[block / kWordBits] & bit(block)) != 0;
  }
  [[nodiscard]] bool contains_all(const BlockSet& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if ((other.words_[i] & ~words_[i]) != 0) return false;
    }
    return true;
  }
  [[nodiscard]] bool empty() const {
    return std::all_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word == 0; });
  }

  /// Calls `visit(block)` for each block in ascending order.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      for (std::uint64_t left = words_[i]; left != 0; left &= left - 1) {
        visit(kWordBits * i + static_cast<std::size_t>(std::countr_zero(left)));
      }
    }
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace aucast::face
