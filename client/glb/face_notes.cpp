#include "client/glb/face_notes.h"

#include <cmath>
#include <optional>

#include "client/face/side_word.h"
#include "client/glb/units.h"

namespace aucast::glb {
namespace {

/// Four decimals: more is noise in a table for people.
double rounded(float value) {
  return std::round(static_cast<double>(value) * 1e4) / 1e4;
}

/// Which targets and joints make one side of an AU, or both.
class Recipes {
 public:
  Recipes(const face::Face& face, const MorphTargets& targets, const FaceRig& rig)
      : face_(face), targets_(targets), rig_(rig) {}

  /// {"targets": {NAME: weight}, "joints": {CHANNEL: share}}, without what is empty.
  [[nodiscard]] Json of(int number, Side side) const {
    Json recipe = Json::object();
    const auto recording = face_.recordings.find(number);
    if (recording == face_.recordings.end()) return recipe;
    for (const Target& target : targets_.all()) {
      const float weight =
          target.au == 0 ? target.weight(channel(recording->second, target.channel, side))
          : target.au == number && (side == Side::Both || side == target.side) ? 1.0F
                                                                               : 0.0F;
      if (weight > 0) recipe["targets"][target.name] = rounded(weight);
    }
    for (std::size_t i = 0; i < face_.channels.size(); ++i) {
      const float share = rig_.takes(i) ? channel(recording->second, i, side) : 0;
      if (share > 0) recipe["joints"][face_.channels[i].name] = rounded(share);
    }
    return recipe;
  }

 private:
  [[nodiscard]] float channel(const face::AuRecording& recording, std::size_t i, Side side) const {
    const face::Channel& channel = face_.channels[i];
    const bool other = side != Side::Both && channel.side == opposite(side);
    return other ? 0 : recording.activation[i] / channel.activation_max;
  }

  const face::Face& face_;
  const MorphTargets& targets_;
  const FaceRig& rig_;
};

/// What each channel of a joint does at share 1.
Json joint_channels(const face::Face& face, const FaceRig& rig) {
  Json channels = Json::object();
  for (std::size_t i = 0; i < face.channels.size(); ++i) {
    if (!rig.takes(i)) continue;
    std::vector<float> activations(face.channels.size());
    activations[i] = face.channels[i].activation_max;
    const std::vector<JointPose> poses = rig.pose(activations);
    Json moved = Json::object();
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const JointPose& pose = poses[k];
      if (!pose.moved()) continue;
      const glm::vec3 shift = kMetresPerUnit * pose.translation;
      moved[rig.joints()[k].name] = {
          {"rotation",
           {rounded(pose.rotation.x), rounded(pose.rotation.y), rounded(pose.rotation.z),
            rounded(pose.rotation.w)}},
          {"shift", {rounded(shift.x), rounded(shift.y), rounded(shift.z)}}};
    }
    channels[face.channels[i].name] = std::move(moved);
  }
  return channels;
}

Json action_units(const face::Face& face, const Recipes& recipes) {
  Json all = Json::array();
  for (const auto& [number, recording] : face.recordings) {
    if (number == 0) continue;
    Json one{{"number", number}};
    if (const auto name = facs_name(number)) one["name"] = std::string(*name);
    one.update(recipes.of(number, Side::Both));
    all.push_back(std::move(one));
  }
  return all;
}

Json arkit(const Recipes& recipes, const sources::ArkitTable& table) {
  Json curves = Json::object();
  for (const sources::ArkitCurve& curve : table.curves) {
    Json recipe = recipes.of(curve.number, curve.side);
    if (recipe.empty()) continue;
    curves[curve.curve] = {{"au", curve.number}, {"side", face::side_word(curve.side)}};
    curves[curve.curve].update(recipe);
  }
  return curves;
}

}  // namespace

Json face_notes(const face::Face& face, const MorphTargets& targets, const FaceRig& rig,
                const About& about) {
  const bool muscles = targets.basis() == Basis::Muscles;
  const Recipes recipes(face, targets, rig);
  Json notes{{"face", face.name}};
  if (!about.licence.empty()) notes["licence"] = about.licence;
  notes["units"] = "metres; +y up, +z the way the face looks, +x the subject's left";
  notes["basis"] = muscles ? "muscles" : "aus";
  notes["weights"] =
      muscles ? "0 to 1: a muscle's contraction of its largest. Where several Action Units name "
                "one target, the largest weight counts. NAME_arc is what NAME does beyond a "
                "straight way: at weight w of NAME it has 4 w (1 - w)."
              : "0 to 1: an Action Unit's intensity on one side, the subject's own. Both sides "
                "together are the whole Action Unit.";
  notes["joints"] =
      "Head and eyes are nodes, and with targets of muscles the jaw too: jointChannels has the "
      "rotation (x, y, z, w) and the shift (from where the node is at rest) of share 1. The target "
      "jaw is the little that its node leaves over.";
  if (!about.sound.empty()) {
    notes["sound"] = {{"file", about.sound}, {"starts", "with the animation, at 0 s"}};
  }
  notes["jointChannels"] = joint_channels(face, rig);
  notes["actionUnits"] = action_units(face, recipes);
  notes["arkit52"] = arkit(recipes, about.curves);
  return notes;
}

}  // namespace aucast::glb
