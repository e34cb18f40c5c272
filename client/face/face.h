#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "client/face/face_mesh.h"
#include "client/face/muscle.h"
#include "common/action_unit.h"
#include "common/result.h"

namespace aucast::face {

/// The side of something at `x` (mesh units). It is Both if `x` is within 0.05 of the middle.
[[nodiscard]] Side side_at(float x);

/// One thing that can be driven: a muscle, the jaw, a lid, an eye, the head, a crease. Its
/// activation is >= 0; the opposite movement is another channel. Its side follows from its place
/// (side_at()), never from its name.
struct Channel {
  std::string name;
  Side side = Side::Both;
  float activation_max = kMuscleMax;  ///< muscles 2 or less (classic folders 4), jaw 4, others 1
  /// True for channels that close a lid: the largest demand counts, whichever mixer is chosen.
  /// Otherwise a blink during a smile would leave the eyes half closed.
  bool takes_largest = false;
  /// A crease's depth when nothing drives it: what the skin keeps of its expressions.
  float kept = 0;
};

/// The jaw turns about the x axis through `hinge`: each vertex by degrees_per_unit x activation x
/// its weight in the map "jaw".
struct Jaw {
  glm::vec3 hinge{0};
  float degrees_per_unit = 1;
  float forward_per_rad = 0;  ///< mesh units; the condyle slides forward as the jaw opens
};

/// Both lids turn about the x axis through the eye's centre: each vertex by its weight in the map
/// "lid_angle" (radians at full closure, signed) x closure. Raising turns the lids the other way,
/// by up to raise_max times the angle of full closure.
struct Lids {
  float raise_max = 0.2F;

  /// The share of the closing angle by which an activation of lid_raise lifts the lid. It rises
  /// steeply at first, so that even a slight AU 5 (5B, as in surprise) is visible: a tenth of a
  /// millimetre of lid changes how a face looks.
  [[nodiscard]] float raised(float activation) const {
    return raise_max * activation * (1.8F - 0.8F * activation);
  }
};

struct Eye {
  std::string part;  ///< the mesh part that turns
  glm::vec3 centre{0};
  float yaw_deg = 28;    ///< gaze to the side at 100 %
  float pitch_deg = 22;  ///< gaze up or down at 100 %
};

/// The head turns about `pivot`, each vertex by its weight in the map "head". The angles are those
/// at 100 %.
struct HeadPose {
  glm::vec3 pivot{0};
  float turn_deg = 35;
  float pitch_deg = 22;
  float tilt_deg = 22;
  float shift = 1;  ///< AU 57 and 58: mesh units at 100 %
};

/// Hair below the height of `hinge` swings after the head: the deeper, the further.
struct Hair {
  glm::vec3 hinge{0};   ///< in the middle of the head
  float swing_deg = 6;  ///< how far the lowest ends swing at most when the head turns
};

/// How far the hair hangs from where it lies at rest: shares of Hair::swing_deg in [-1, 1], with
/// the signs of the head's own turn, pitch and tilt. While the head turns to the left, hair that
/// stays behind has a negative turn.
struct HairSway {
  float turn = 0;
  float pitch = 0;
  float tilt = 0;
  bool operator==(const HairSway&) const = default;
};

/// What one AU does at full intensity on both sides. A channel of one side takes that side's
/// intensity, a central one the larger of both (muscle_mixer.h).
struct AuRecording {
  int number = 0;
  std::vector<float> activation;  ///< one per channel, in the order of Face::channels
  std::string note;
};

using AuRecordings = std::map<int, AuRecording>;  ///< by AU number

/// A face as it was loaded. It is never copied and never changed: code that edits recordings keeps
/// a copy of them. Only the window replaces a face by another one (app/window/making/face_session).
/// Order of channels: muscles as in the file, then jaw, left_lid_close, right_lid_close,
/// left_lid_raise, right_lid_raise, {left,right}_gaze_{left,right,up,down}, head_turn_left,
/// head_turn_right, head_up, head_down, head_tilt_left, head_tilt_right, head_forward, head_back,
/// then the creases, each named after its part. Channels for which the face has no geometry are
/// left out.
struct Face {
  std::string name;
  std::string
      copy_of;  ///< the face that this one was copied from: its name or folder; empty: no copy
  FaceMesh mesh;
  std::vector<Channel> channels;
  std::vector<Muscle> muscles;  ///< muscles[i] is driven by channels[i]
  std::optional<Jaw> jaw;
  std::optional<Lids> lids;
  std::vector<Eye> eyes;  ///< the left eye first
  std::optional<HeadPose> head;
  std::optional<Hair> hair;  ///< nullopt: it goes with the head as one piece
  AuRecordings recordings;
  /// Messages to be shown to the user once: about duplicates that were dropped and AUs that this
  /// face cannot show.
  std::vector<std::string> remarks;
  bool classic = false;  ///< from a folder in Waters' format

  [[nodiscard]] std::optional<std::size_t> channel_index(std::string_view channel_name) const;
};

/// Reads a face folder: our format (face.toml inside) or Waters' classic one (faceline.dat inside).
/// `data_folder` holds the AU table for classic folders. Fails with BadData and file:line:column,
/// or with Unreadable if a file is missing.
[[nodiscard]] Result<Face> load_face(const std::filesystem::path& folder,
                                     const std::filesystem::path& data_folder);

}  // namespace aucast::face
