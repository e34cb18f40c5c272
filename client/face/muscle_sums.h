#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "client/face/face.h"
#include "client/face/pull_table.h"
#include "client/face/vertex_block.h"

namespace aucast::face {

/// The neutral face plus the displacements of all muscles. Displacements per unit of activation are
/// computed once and stored by block, so that a block is summed in one pass. Most muscles pull all
/// their vertices in one direction (their "way") and differ only in how far they pull each. For
/// these muscles one number per vertex is stored instead of three.
class MuscleSums {
 public:
  explicit MuscleSums(const Face& face);
  class Making;

  /// Sets the activations, one per muscle, finite. Adds to `moved` the blocks of the muscles whose
  /// activation has changed.
  void take(std::span<const float> activations, BlockSet& moved);

  /// Prepares at() for these blocks, until the next take().
  void list(const BlockSet& blocks);

  /// Sets `place` to the vertices of a listed block, displaced by all muscles. The displacements
  /// are always added in the same order.
  void at(std::size_t block, VertexBlock& place) const;

  [[nodiscard]] const std::vector<VertexBlock>& rest() const { return rest_; }

 private:
  MuscleSums() = default;

  struct Reach {
    float activation_cap = 0;
    BlockSet blocks;
    glm::vec3 way{1};  ///< the longest pull per unit of activation; 1, 1, 1 if the pulls differ in
                       ///< direction
  };

  /// A muscle's way times its activation, in all four lanes.
  struct Factors {
    Four x{};
    Four y{};
    Four z{};
  };

  std::vector<VertexBlock> rest_;
  std::vector<Reach> reaches_;       ///< one per muscle
  std::vector<float> activations_;   ///< capped, one per muscle
  std::vector<std::uint32_t> acts_;  ///< 1 for a muscle that is active, else 0
  bool others_act_ = false;          ///< since blocks were last listed, a muscle has become
                                     ///< active or inactive
  BlockSet listed_;                  ///< the blocks for which at() may be called
  std::vector<Factors> factors_;     ///< one per muscle
  PullTable<Lanes> along_;           ///< the pulls of muscles with a way, as shares of it
  PullTable<VertexBlock> free_;      ///< the pulls of all other muscles, per unit of activation
};

/// Makes MuscleSums in portions of about a millisecond. The face must outlive it.
class MuscleSums::Making {
 public:
  explicit Making(const Face& face);
  /// Adds the next muscle. Returns true when all have been added; then call finish().
  [[nodiscard]] bool step();
  [[nodiscard]] MuscleSums finish();

 private:
  void add(const Muscle& muscle);

  const Face& face_;
  MuscleSums sums_;
  std::vector<glm::vec3> pulls_;  ///< of one muscle
  std::vector<PullTable<Lanes>::Entry> along_;
  std::vector<PullTable<VertexBlock>::Entry> free_;
};

}  // namespace aucast::face
