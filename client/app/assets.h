#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/app/player_options.h"
#include "client/face/co_occurrence_rules.h"
#include "client/face/face.h"
#include "common/result.h"

namespace aucast::app {

/// A named set of AUs, such as a prototype of an emotion.
struct Expression {
  std::string name;   ///< what --expression takes
  std::string label;  ///< for people
  AuFrame aus;
  std::string source;
};

/// What the files say, read once at the start.
struct Assets {
  std::filesystem::path data_folder;
  face::Face face;
  face::RuleSet rules;
  std::vector<Expression> expressions;
};

[[nodiscard]] Result<std::vector<Expression>> load_expressions(const std::filesystem::path& file);

/// Reads face, rules and expressions; what a face has to say (Face::remarks) goes to the log.
[[nodiscard]] Result<std::unique_ptr<Assets>> load_assets(const FaceOptions& options);

/// The expression with this name; Usage error with the nearest one.
[[nodiscard]] Result<AuFrame> find_expression(const Assets& assets, const std::string& name);

/// The label of the expression that has exactly these AUs, else the AUs themselves: for captions.
[[nodiscard]] std::string describe(const Assets& assets, const AuFrame& aus);

}  // namespace aucast::app
