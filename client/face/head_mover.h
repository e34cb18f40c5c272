#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "client/face/face.h"
#include "client/face/vertex_block.h"

namespace aucast::face {

/// Turns vertices with the head: tilt, nod about the axis through its own ears, turn, shift.
/// Thread: one per thread.
class HeadMover {
 public:
  /// Turns as shares of the face's full ones, in [-1, 1].
  struct Pose {
    float turn = 0;   ///< to the subject's left
    float pitch = 0;  ///< up
    float tilt = 0;   ///< to the subject's left
    float shift = 0;  ///< forward
    bool operator==(const Pose&) const = default;
  };

  explicit HeadMover(const Face& face);

  /// The pose that counts from here on. When it is another one than before, adds to `moved` the
  /// blocks that go with the head.
  void take(const Pose& pose, BlockSet& moved);

  /// Whether anything is elsewhere than without the head's turn.
  [[nodiscard]] bool turned() const { return pose_ != Pose{}; }

  /// Where the head carries a block that is at `from` before.
  void apply(std::size_t block, const VertexBlock& from, VertexBlock& to) const;

  /// A point and a direction that take the given part in the head's turn.
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

  /// A turn and a shift, each number in all lanes: axes[a] is where the a-th axis goes.
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
  BlockSet carried_;  ///< not of kind Not
  Pose pose_;
  Angles angles_;
  Motion motion_;  ///< of what turns wholly
};

}  // namespace aucast::face
