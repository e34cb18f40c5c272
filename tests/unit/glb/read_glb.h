#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/glb/glb_file.h"

namespace aucast::glb::test {

/// A binary glTF file taken apart, and its numbers as a viewer reads them.
class ReadGlb {
 public:
  /// Checks the header and the lengths of both chunks.
  explicit ReadGlb(const std::string& bytes) {
    const auto word = [&bytes](std::size_t at) { return number<std::uint32_t>(bytes, at); };
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), bytes.size());
    const std::size_t json = word(12);
    EXPECT_EQ(json % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const std::size_t length = word(20 + json);
    EXPECT_EQ(length % 4, 0U);
    EXPECT_EQ(bytes.substr(24 + json, 4), std::string("BIN\0", 4));
    EXPECT_EQ(bytes.size(), 28 + json + length);
    document = Json::parse(bytes.substr(20, json));
    binary = bytes.substr(28 + json);
  }

  using Rows = std::vector<std::vector<float>>;

  /// What an accessor stands for, a row for each element: floats as they are, whole numbers as
  /// shares of their largest where they are normalised, and of sparse ones all others 0.
  [[nodiscard]] Rows rows(std::size_t index) const {
    const Json& accessor = document["accessors"].at(index);
    const std::size_t width = width_of(accessor["type"].get<std::string>());
    const std::size_t count = accessor["count"];
    Rows all(count, std::vector<float>(width));
    if (accessor.contains("bufferView")) {
      const std::size_t at = begin_of(accessor["bufferView"]);
      for (std::size_t i = 0; i < count; ++i) all[i] = row(accessor, at, i, width);
    }
    if (!accessor.contains("sparse")) return all;
    const Json& sparse = accessor["sparse"];
    const Json& indices = sparse["indices"];
    const Json& values = sparse["values"];
    const std::size_t from = begin_of(indices["bufferView"]) + at_or_0(indices);
    const std::size_t values_from = begin_of(values["bufferView"]) + at_or_0(values);
    for (std::size_t i = 0; i < sparse["count"].get<std::size_t>(); ++i) {
      const auto vertex = static_cast<std::size_t>(component(indices["componentType"], from, i));
      all.at(vertex) = row(accessor, values_from, i, width);
    }
    return all;
  }
  [[nodiscard]] Rows rows(const Json& index) const { return rows(index.get<std::size_t>()); }

  /// The node of this name; a failure, and an empty one, if there is none.
  [[nodiscard]] const Json& node(const std::string& name) const {
    static const Json kNone = Json::object();
    for (const Json& one : document["nodes"]) {
      if (one["name"] == name) return one;
    }
    ADD_FAILURE() << "no node " << name;
    return kNone;
  }
  [[nodiscard]] const Json& mesh(const std::string& name) const {
    return document["meshes"].at(node(name)["mesh"].get<std::size_t>());
  }
  [[nodiscard]] const Json& primitive(const std::string& name) const {
    return mesh(name)["primitives"][0];
  }
  [[nodiscard]] const Json& material(const std::string& name) const {
    return document["materials"].at(primitive(name)["material"].get<std::size_t>());
  }

  [[nodiscard]] std::size_t begin_of(const Json& view) const {
    return document["bufferViews"].at(view.get<std::size_t>())["byteOffset"];
  }
  [[nodiscard]] static std::size_t width_of(const std::string& type) {
    if (type == "SCALAR") return 1;
    return type == "MAT4" ? 16 : static_cast<std::size_t>(type.back() - '0');
  }
  [[nodiscard]] static std::size_t bytes_of(int component_type) {
    return component_type >= 5125 ? 4 : component_type >= 5122 ? 2 : 1;
  }

  Json document;
  std::string binary;

 private:
  template <typename T>
  [[nodiscard]] static T number(const std::string& bytes, std::size_t at) {
    T value{};
    EXPECT_LE(at + sizeof value, bytes.size());
    if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }
  [[nodiscard]] static std::size_t at_or_0(const Json& part) {
    return part.value("byteOffset", 0U);
  }

  /// Number `i` behind a place, as it is stored.
  [[nodiscard]] float component(int type, std::size_t from, std::size_t i) const {
    const std::size_t at = from + i * bytes_of(type);
    switch (type) {
      case 5120:
        return number<std::int8_t>(binary, at);
      case 5121:
        return number<std::uint8_t>(binary, at);
      case 5122:
        return number<std::int16_t>(binary, at);
      case 5123:
        return number<std::uint16_t>(binary, at);
      case 5125:
        return static_cast<float>(number<std::uint32_t>(binary, at));
      default:
        return number<float>(binary, at);
    }
  }
  [[nodiscard]] std::vector<float> row(const Json& accessor, std::size_t from, std::size_t i,
                                       std::size_t width) const {
    const int type = accessor["componentType"];
    const std::array<float, 4> largest{127, 255, 32'767, 65'535};
    const bool shares = accessor.value("normalized", false);
    std::vector<float> values;
    for (std::size_t k = 0; k < width; ++k) {
      const float value = component(type, from, i * width + k);
      values.push_back(shares ? value / largest.at(static_cast<std::size_t>(type) - 5120) : value);
    }
    return values;
  }
};

}  // namespace aucast::glb::test
