#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/action_unit.h"
#include "common/result.h"

namespace aucast {

/// A muscle that an expression sets directly, without an AU: its activation on each of the
/// subject's sides.
struct ExpressionMuscle {
  std::string name;                    ///< without left_ or right_
  std::vector<std::string> spellings;  ///< its names in Waters' face folders
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
  std::optional<std::array<float, 2>> pad;  ///< its place on the axes sad-happy and calm-excited
};

/// Reads a file in the form of data/expressions.toml. Fails with Unreadable, or with BadData and
/// file:line:column; a file without any expression is BadData.
[[nodiscard]] Result<std::vector<Expression>> load_expressions(const std::filesystem::path& file);

}  // namespace aucast
