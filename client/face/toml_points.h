#pragma once

#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "common/toml_reader.h"

namespace aucast::face {

/// Reads a required array of three numbers.
[[nodiscard]] inline glm::vec3 read_point(TableReader& reader, std::string_view key,
                                          const Bounds& bounds = {}) {
  const auto [x, y, z] = reader.numbers<3>(key, bounds);
  return {x, y, z};
}

/// Reads a required array of two numbers.
[[nodiscard]] inline glm::vec2 read_pair(TableReader& reader, std::string_view key,
                                         const Bounds& bounds = {}) {
  const auto [x, y] = reader.numbers<2>(key, bounds);
  return {x, y};
}

}  // namespace aucast::face
