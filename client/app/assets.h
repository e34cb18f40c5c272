#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "client/app/player_options.h"
#include "client/face/co_occurrence_rules.h"
#include "client/face/face.h"
#include "client/pipeline/au_mapping.h"
#include "common/expressions/expressions.h"
#include "common/result.h"

namespace aucast::app {

/// What is read from files once at the start.
struct Assets {
  std::filesystem::path data_folder;
  std::filesystem::path face_folder;
  face::Face face;
  face::RuleSet rules;
  std::vector<Expression> expressions;
  std::map<int, std::string> au_looks;  ///< what each AU looks like, in words
};

/// Reads from data/action_units.toml what each AU looks like, by AU number.
[[nodiscard]] Result<std::map<int, std::string>> load_au_looks(const std::filesystem::path& file);

/// The folder that --face names: a path, or the name of one in data/faces.
[[nodiscard]] std::filesystem::path face_folder(const FaceOptions& options,
                                                const std::filesystem::path& data);

/// Reads face, rules and expressions, and logs Face::remarks.
[[nodiscard]] Result<std::unique_ptr<Assets>> load_assets(const FaceOptions& options);

/// The expression with this name. If there is none, fails with Usage and suggests the nearest name.
[[nodiscard]] Result<Expression> find_expression(const Assets& assets, const std::string& name);

/// The expression with all its intensities and activations times `strength`, in [0,1].
[[nodiscard]] Expression at_strength(Expression expression, float strength);

/// The mapping for the face of `assets`.
[[nodiscard]] inline pipeline::AuMapping au_mapping(const Assets& assets, face::Mixer mixer) {
  return {assets.face, assets.face.recordings, assets.rules, mixer};
}

/// A caption for these AUs: the label of the first expression that has exactly these AUs, else the
/// AUs themselves.
[[nodiscard]] std::string describe(const Assets& assets, const AuFrame& aus);

}  // namespace aucast::app
