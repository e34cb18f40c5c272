#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "client/face/face.h"
#include "client/face/vertex_block.h"

namespace aucast::face {

/// Moves vertices with the head: tilt, then nod about the axis through the ears, turn and shift.
/// Thread: one object per thread.
class HeadMover {
 public:
  /// Shares of the face's full turns and shift, in [-1, 1].
  struct Pose {
    float turn = 0;   ///< to the subject's left
    float pitch = 0;  ///< up
    float tilt = 0;   ///< to the subject's left
    float shift = 0;  ///< forward
    bool operator==(const Pose&) const = default;
  };

  explicit HeadMover(const Face& face);

  /// Sets the pose. If it differs from the previous one, adds to `moved` the blocks that go with
  /// the head.
  void take(const Pose& pose, BlockSet& moved);

  /// Whether the head is turned or shifted at all.
  [[nodiscard]] bool turned() const { return pose_ != Pose{}; }

  /// Sets `to` to the place to which the head carries the block number `block`. `from` is the place
  /// of the block while the head is not turned.
  void apply(std::size_t block, const VertexBlock& from, VertexBlock& to) const;

  /// Moves a point and a direction with the head, by `share` in [0,1] of the head's own motion.
  void carry(float share, glm::vec3& point, glm::vec3& direction) const;

 private:
  /// How the vertices of a block go with the head.
  enum class Kind : std::uint8_t { Not, Wholly, Bent };
  struct Angles {
    float tilt = 0;
    float pitch = 0;
    float turn = 0;
    float shift = 0;
  };

  /// A turn and a shift, each number repeated in all lanes. axes[a]: where the turn takes axis a.
  struct Motion {
    struct Point {
      Four x{};
      Four y{};
      Four z{};
    };
    std::array<Point, 3> axes;
    Point translation;
  };

  void turn_rigidly(const VertexBlock& from, VertexBlock& to) const;
  void turn_by_angles(const Lanes& weights, VertexBlock& block) const;

  HeadPose head_;
  std::vector<Lanes> weights_;  ///< one per block
  std::vector<Kind> kinds_;
  BlockSet carried_;  ///< all blocks but those of Kind::Not
  Pose pose_;
  Angles angles_;
  Motion motion_;  ///< for blocks of Kind::Wholly
};

}  // namespace aucast::face
