#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "client/face/vertex_block.h"

namespace aucast::face {

/// The pulls of muscles on blocks of vertices, sorted by block and then by muscle, and a list of
/// the pulls whose muscle is active. Most expressions use few muscles; to test all the others for
/// each block would take longer than the sums.
template <typename Pull>
class PullTable {
 public:
  struct Entry {
    std::uint32_t block = 0;
    std::uint32_t muscle = 0;
    Pull pull{};
  };

  /// A pull of an active muscle: its byte position in the table of pulls, and that of its muscle in
  /// the caller's table of muscles. Bytes rather than indices save multiplications.
  struct Acting {
    std::uint32_t pull = 0;
    std::uint32_t muscle = 0;
  };

  /// An empty table without blocks.
  PullTable() = default;

  /// `entries`: in the muscles' order. No muscle is active at first.
  PullTable(std::size_t block_count, std::vector<Entry> entries)
      : acting_(entries.size() + kAhead), acting_in_(block_count) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.block < b.block; });
    for (const Entry& entry : entries) {
      begin_.resize(entry.block + 1, static_cast<std::uint32_t>(pulls_.size()));
      pulls_.push_back(entry.pull);
      muscles_.push_back(entry.muscle);
    }
    begin_.resize(block_count + 1, static_cast<std::uint32_t>(pulls_.size()));
  }

  /// Lists the pulls of active muscles for acting(), in the order of `blocks`. `acts`: 1 for each
  /// active muscle, else 0. `muscle_bytes`: the size of an element of the caller's table of
  /// muscles. The function has no branches, because no processor could predict them here.
  void list_acting(std::span<const std::uint32_t> acts, std::size_t muscle_bytes,
                   const BlockSet& blocks) {
    std::uint32_t count = 0;
    blocks.for_each([&](std::size_t block) {
      acting_in_[block].begin = count;
      for (std::uint32_t i = begin_[block]; i < begin_[block + 1]; ++i) {
        const std::uint32_t muscle = muscles_[i];
        acting_[count] = {static_cast<std::uint32_t>(i * sizeof(Pull)),
                          static_cast<std::uint32_t>(muscle * muscle_bytes)};
        count += acts[muscle];
      }
      acting_in_[block].end = count;
    });
  }

  /// The pulls of active muscles on a listed block.
  [[nodiscard]] std::span<const Acting> acting(std::size_t block) const {
    return {acting_.data() + acting_in_[block].begin, acting_.data() + acting_in_[block].end};
  }

  /// The pull that `acting` refers to. Also prefetches a later pull: pulls lie too far apart for
  /// the processor to do so on its own.
  [[nodiscard]] const Pull& fetch(const Acting& acting) const {
    const Pull& later = at_distance(pulls_.data(), (&acting)[kAhead].pull);
    __builtin_prefetch(&later);
    if constexpr (sizeof(Pull) > kCacheLine) __builtin_prefetch(&later + 1);
    return at_distance(pulls_.data(), acting.pull);
  }

 private:
  /// A run of acting_.
  struct Run {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  static constexpr std::size_t kAhead = 16;
  static constexpr std::size_t kCacheLine = 64;

  std::vector<std::uint32_t> begin_;  ///< pulls on block b: begin_[b] to begin_[b + 1]
  std::vector<Pull> pulls_;
  std::vector<std::uint32_t> muscles_;  ///< for each pull, its muscle
  std::vector<Acting> acting_;  ///< followed by kAhead unused ones, which fetch() may look at
  std::vector<Run> acting_in_;  ///< one per block
};

}  // namespace aucast::face
