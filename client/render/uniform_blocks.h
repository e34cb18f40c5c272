#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"

namespace aucast::render {

// The uniform blocks of shaders/common.glsl, which explains their members, in std140 layout: a vec3
// begins at a multiple of 16 bytes, and a float may follow in its last 4 bytes.

struct CameraBlock {
  static constexpr GLuint kSlot = 0;
  glm::mat4 world_to_clip{1};
  glm::mat4 world_to_shadow{1};
  glm::vec3 eye{0};
  float scale = 1;
  glm::vec2 viewport_px{1};
  glm::vec2 unused{0};
};
static_assert(sizeof(CameraBlock) == 160);

struct LightsBlock {
  static constexpr GLuint kSlot = 1;
  alignas(16) glm::vec3 key_direction{0, 0, 1};
  float key_strength = 1;
};
static_assert(sizeof(LightsBlock) == 16);

struct MaterialBlock {
  static constexpr GLuint kSlot = 2;
  alignas(16) glm::vec3 wrap{0};
  float specular = 0;
  alignas(16) glm::vec3 shadow_kept{0};
  float power = 1;
  float grain = 0;
  float thinning = 0;
  float grey = 0;
  float enclosed = 0;
};
static_assert(sizeof(MaterialBlock) == 48);

/// Blocks of one kind in a buffer, of which the programs read one at a time. Needs a current
/// context as long as it lives.
template <typename Block>
class BlockBuffer {
 public:
  void set(const Block& block) {
    stride_ = sizeof(Block);
    upload(&block, sizeof(Block));
  }

  void set(std::span<const Block> blocks) {
    GLint alignment = 1;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const auto step = static_cast<std::size_t>(alignment);
    stride_ = (sizeof(Block) + step - 1) / step * step;
    std::vector<std::byte> bytes(stride_ * blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      std::memcpy(&bytes[i * stride_], &blocks[i], sizeof(Block));
    }
    upload(bytes.data(), bytes.size());
  }

  /// Makes the programs read the block number `index` from now on.
  void use(std::size_t index = 0) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, Block::kSlot, buffer_.id(),
                      static_cast<GLintptr>(index * stride_), sizeof(Block));
  }

 private:
  void upload(const void* bytes, std::size_t size) {
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(size), bytes, GL_STREAM_DRAW);
  }

  Buffer buffer_;
  std::size_t stride_ = 0;
};

}  // namespace aucast::render
