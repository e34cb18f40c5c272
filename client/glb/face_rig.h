#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/face/face.h"
#include "client/face/opposed_channels.h"

namespace aucast::glb {

/// A joint in the sense of glTF: something that turns as a whole. At rest no joint is turned.
struct Joint {
  std::string name;
  std::size_t parent = 0;  ///< index into joints(); the first joint is its own parent
  glm::vec3 position{0};   ///< in the neutral face, mesh units
};

/// A joint's rotation and translation relative to its parent, counted from rest.
struct JointPose {
  glm::quat rotation = glm::identity<glm::quat>();
  glm::vec3 translation{0};  ///< mesh units

  [[nodiscard]] bool moved() const {
    return rotation != glm::identity<glm::quat>() || translation != glm::vec3(0);
  }
};

/// Which joints carry a vertex, and the weight of each. Weights sum to 1.
struct Carried {
  std::array<std::uint8_t, 4> joints{};
  std::array<float, 4> weights{1, 0, 0, 0};

  /// The one joint that carries the whole vertex; nullopt if several carry it.
  [[nodiscard]] std::optional<std::size_t> wholly() const;
};

/// The joints of a face: body, neck, head, jaw and eyes, as far as it has them. The neck turns half
/// as far as the head, so that the skin between body and head turns in two steps and keeps most of
/// its girth. The face must outlive it.
class FaceRig {
 public:
  /// If `with_jaw` is false, the jaw is no joint, and a morph target opens the mouth.
  FaceRig(const face::Face& face, bool with_jaw);

  [[nodiscard]] std::span<const Joint> joints() const { return joints_; }
  /// A joint's position at rest minus its parent's, mesh units.
  [[nodiscard]] glm::vec3 from_parent(std::size_t joint) const;
  /// Whether a joint follows this channel.
  [[nodiscard]] bool takes(std::size_t channel) const;
  /// The channel that the jaw follows; nullopt if the jaw is no joint. Skin between jaw and head
  /// moves by a mean of the two joints; a morph target adds the rest.
  [[nodiscard]] std::optional<std::size_t> jaw_channel() const { return jaw_channel_; }
  [[nodiscard]] Carried carried(std::size_t vertex) const;

  /// The pose of each joint. `activations`: one per channel.
  [[nodiscard]] std::vector<JointPose> pose(std::span<const float> activations) const;
  /// For each joint, the matrix that takes a point of the neutral face to where the joint carries
  /// it.
  [[nodiscard]] std::vector<glm::mat4> carriers(std::span<const JointPose> poses) const;

 private:
  struct EyeJoint {
    std::size_t joint = 0;
    face::OpposedChannels yaw;
    face::OpposedChannels pitch;
    float yaw_rad = 0;
    float pitch_rad = 0;
    std::uint32_t vertex_begin = 0;
    std::uint32_t vertex_end = 0;
  };

  std::size_t add(std::string name, std::size_t parent, const glm::vec3& position);
  face::OpposedChannels take(const face::OpposedNames& names, Side side = Side::Both);
  void add_head();
  void add_jaw(std::size_t parent);
  void add_eye(const face::Eye& eye, std::size_t parent);

  const face::Face& face_;
  std::vector<Joint> joints_;
  std::vector<std::size_t> taken_;   ///< the channels that joints follow
  std::optional<std::size_t> head_;  ///< the neck is the joint before it
  std::optional<std::size_t> jaw_;
  std::optional<std::size_t> jaw_channel_;
  std::vector<EyeJoint> eyes_;
  face::OpposedChannels turn_;
  face::OpposedChannels pitch_;
  face::OpposedChannels tilt_;
  face::OpposedChannels shift_;
};

}  // namespace aucast::glb
