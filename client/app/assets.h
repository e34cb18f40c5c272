#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/app/player_options.h"
#include "client/face/co_occurrence_rules.h"
#include "client/face/face.h"
#include "client/pipeline/au_mapping.h"
#include "common/result.h"

namespace aucast::app {

/// A muscle that an expression sets by itself, without an AU: activations of the subject's sides.
struct ExpressionMuscle {
  std::string name;                    ///< without left_ or right_
  std::vector<std::string> spellings;  ///< of the same muscle in classic folders
  float left = 0;
  float right = 0;
};

/// A named face, such as a prototype of an emotion: a set of AUs, or muscles, or both.
struct Expression {
  std::string name;   ///< what --expression takes
  std::string label;  ///< for people
  AuFrame aus;
  std::vector<ExpressionMuscle> muscles;
  std::string source;
  std::optional<std::array<float, 2>> pad;  ///< place on the axes sad-happy and calm-excited
};

/// What the files say, read once at the start.
struct Assets {
  std::filesystem::path data_folder;
  std::filesystem::path face_folder;
  face::Face face;
  face::RuleSet rules;
  std::vector<Expression> expressions;
  std::map<int, std::string> au_looks;  ///< what each AU looks like, in words
};

[[nodiscard]] Result<std::vector<Expression>> load_expressions(const std::filesystem::path& file);

/// The texts of data/action_units.toml.
[[nodiscard]] Result<std::map<int, std::string>> load_au_looks(const std::filesystem::path& file);

/// Reads face, rules and expressions; what a face has to say (Face::remarks) goes to the log.
[[nodiscard]] Result<std::unique_ptr<Assets>> load_assets(const FaceOptions& options);

/// The expression with this name; Usage error with the nearest one.
[[nodiscard]] Result<Expression> find_expression(const Assets& assets, const std::string& name);

/// The same with all intensities and activations times `strength`, in [0,1].
[[nodiscard]] Expression at_strength(Expression expression, float strength);

/// Sets an expression's muscles on top of `activations` (one per channel of the face): the larger
/// value counts, cut to what the channel can do. BadData when the face has no such muscle.
[[nodiscard]] Result<void> apply_muscles(const face::Face& face, const Expression& expression,
                                         std::span<float> activations);

/// How the face of `assets` is driven.
[[nodiscard]] inline pipeline::AuMapping au_mapping(const Assets& assets, face::Mixer mixer) {
  return {assets.face, assets.face.recordings, assets.rules, mixer};
}

/// The label of the first expression that is exactly these AUs, else the AUs themselves: for
/// captions.
[[nodiscard]] std::string describe(const Assets& assets, const AuFrame& aus);

}  // namespace aucast::app
