#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/face/face.h"
#include "client/face/face_deformer.h"
#include "client/face/normal_field.h"
#include "client/face/vertex_block.h"

namespace aucast::face {

/// Turns a deformed face with its head: tilt, nod about the axis through its own ears, turn, shift.
/// What turns wholly takes its normals along; only where the neck bends are they computed again.
/// Thread: one per thread.
class HeadTurn {
 public:
  /// Turns as shares of the face's full ones, in [-1, 1].
  struct Pose {
    float turn = 0;   ///< to the subject's left
    float pitch = 0;  ///< up
    float tilt = 0;   ///< to the subject's left
    float shift = 0;  ///< forward
    bool operator==(const Pose&) const = default;
  };

  /// `normals` is copied: of the whole mesh.
  HeadTurn(const Face& face, const NormalField& normals);

  /// Writes to `turned` the face `still`, whose positions are also in `blocks`, as the head in this
  /// pose carries it. `changed`: one flag per block that is different from the last call's.
  void apply(const Pose& pose, std::span<const std::uint8_t> changed,
             std::span<const VertexBlock> blocks, const DeformedFace& still, DeformedFace& turned);

  /// A point and a direction that take the given part in the head's turn.
  void carry(const Pose& pose, float share, glm::vec3& point, glm::vec3& direction) const;

  /// The next apply() writes everything.
  void forget() { last_.reset(); }

 private:
  /// How the vertices of a block go with the head.
  enum class Kind : std::uint8_t { Not, Wholly, Bent };
  struct Angles {
    float tilt = 0;
    float pitch = 0;
    float turn = 0;
    float shift = 0;
  };

  [[nodiscard]] Angles angles_of(const Pose& pose) const;
  void turn(const Angles& angles, const Lanes& weights, VertexBlock& block) const;

  HeadPose head_;
  std::vector<Lanes> weights_;  ///< one per block
  std::vector<Kind> kinds_;
  std::vector<std::uint32_t> bent_;       ///< blocks of that kind
  std::vector<std::uint32_t> near_bent_;  ///< blocks whose vertices their normals need
  NormalField normals_;
  std::optional<Pose> last_;
};

}  // namespace aucast::face
