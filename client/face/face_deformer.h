#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "client/face/face.h"

namespace aucast::face {

/// A deformed face, ready to be drawn: positions and normals in the mesh's order, and where the
/// eyes look.
struct DeformedFace {
  std::vector<glm::vec3> positions;    ///< a crease of depth 0 may be at rest, see FaceDeformer
  std::vector<glm::vec3> normals;      ///< unit length; +z for creases, which take no light
  std::vector<glm::vec3> eye_centres;  ///< as Face::eyes
  std::vector<glm::vec3> eye_forward;  ///< unit length
  std::vector<float> eye_open;         ///< 1: at least as wide as at rest, 0: shut
  std::vector<float> creases;          ///< depth in [0,1], one per part that is a crease, in order
};

/// The neutral face, without the cost of making a deformer. It equals what deform() gives for
/// activations of 0, except that normals may differ in their last digits.
[[nodiscard]] DeformedFace neutral_face(const Face& face);

/// Turns activations into positions. Muscles displace vertices from the neutral face, and their
/// displacements are summed, so that their order does not matter; then lids, jaw, eyes,
/// hair and head turn, in that order. Displacements per unit of activation are computed once, when
/// the deformer is made; deform() computes only the vertices that a changed activation reaches. A
/// crease of depth 0 is not drawn. Its vertices stay at rest, except those that share a block
/// (vertex_block.h) with something that is drawn. The result depends on activations and sway alone,
/// to the last bit, not on earlier calls. The face must outlive the deformer. Thread: one deformer
/// per thread.
class FaceDeformer {
 public:
  explicit FaceDeformer(const Face& face);
  ~FaceDeformer();
  class Making;
  FaceDeformer(FaceDeformer&&) noexcept;
  FaceDeformer& operator=(FaceDeformer&&) noexcept;

  /// `activations`: one per channel, clamped to [0, activation_max]; a value that is not finite is
  /// taken as 0. If all are 0, the positions are those of the face's own mesh bit for bit. `sway`:
  /// how far the hair hangs from its place; it hangs at rest in a still. The result is valid until
  /// the next call. Nothing is allocated after the first call.
  const DeformedFace& deform(std::span<const float> activations, const HairSway& sway = {});

 private:
  struct State;
  explicit FaceDeformer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Makes a deformer in steps of a few milliseconds, for callers that must not block
/// meanwhile. The face must outlive it.
class FaceDeformer::Making {
 public:
  explicit Making(const Face& face);
  ~Making();
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;

  /// Does the next portion. Returns the deformer once, after the last portion.
  [[nodiscard]] std::optional<FaceDeformer> step();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace aucast::face
