#include "client/render/mesh_buffers.h"

#include <algorithm>
#include <cstdint>

#include <glm/common.hpp>

#include "client/render/skin_grain.h"
#include "common/check.h"

namespace aucast::render {
namespace {

using view::Shader;
using Triangle = view::RoundedMesh::Triangle;

/// Mesh units: a quarter of a pixel in a face that fills the screen, so that no corner shows.
constexpr float kLeastBend = 0.004F;
constexpr glm::vec3 kClay{0.52F, 0.47F, 0.43F};  ///< the surface in a plain colour

// Locations of the attributes in shaders/*.glsl.
constexpr GLuint kPositionSlot = 0;
constexpr GLuint kNormalSlot = 1;
constexpr GLuint kColourSlot = 2;
constexpr GLuint kOcclusionGlossSlot = 3;
constexpr GLuint kGrainSlot = 4;
constexpr GLuint kStrandSlot = 5;

MaterialBlock block_of(const view::Material& material, bool grained) {
  // Shadows on skin go red, not grey. With less green and blue round the edge, a red ring lies
  // there and the shade behind it looks blue.
  constexpr glm::vec3 kSkinWrap{0.61F, 0.47F, 0.415F};
  constexpr glm::vec3 kSkinShadow{0.248F, 0.170F, 0.149F};
  return {.wrap = kSkinWrap * material.wrap,
          .specular = material.specular,
          .shadow_kept = glm::max(kSkinShadow * material.wrap, glm::vec3(material.shadow_kept)),
          .power = material.power,
          .grain = grained ? material.grain : 0,
          .thinning = material.thinning,
          .grey = material.grey,
          .enclosed = material.enclosed};
}

template <typename T>
void upload(GLenum target, const Buffer& buffer, std::span<const T> data, GLenum usage) {
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), usage);
}

void draw_as(GLenum mode, const Run& run) {
  glDrawElements(mode, run.index_count, GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(run.first_index * sizeof(std::uint32_t)));
}

}  // namespace

void Run::draw() const {
  draw_as(GL_TRIANGLES, *this);
}

void Run::draw_points() const {
  draw_as(GL_POINTS, *this);
}

MeshBuffers::MeshBuffers() {
  struct Attribute {
    const Buffer& buffer;
    GLuint slot;
    GLint components;
  };
  glBindVertexArray(array_.id());
  for (const auto& [buffer, slot, components] :
       {Attribute{positions_, kPositionSlot, 3}, Attribute{normals_, kNormalSlot, 3},
        Attribute{colours_, kColourSlot, 4}, Attribute{occlusion_gloss_, kOcclusionGlossSlot, 2},
        Attribute{grain_places_, kGrainSlot, 2}, Attribute{strand_ways_, kStrandSlot, 4}}) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glEnableVertexAttribArray(slot);
    glVertexAttribPointer(slot, components, GL_FLOAT, GL_FALSE, 0, nullptr);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  glBindVertexArray(0);
}

void MeshBuffers::bind(bool textured) const {
  glBindVertexArray(array_.id());
  if (textured) {
    glEnableVertexAttribArray(kColourSlot);
    glEnableVertexAttribArray(kStrandSlot);
  } else {
    glDisableVertexAttribArray(kStrandSlot);
    glVertexAttrib4f(kStrandSlot, 0, 0, 0, 0);
    glDisableVertexAttribArray(kColourSlot);
    glVertexAttrib4f(kColourSlot, kClay.r, kClay.g, kClay.b, 1);
  }
}

/// Makes runs of the ranges, and returns the triangles in their order.
MeshBuffers::Triangles MeshBuffers::sort_into_runs(const view::StaticMesh& mesh) {
  // A translucent range is mostly solid (hair): only triangles with a clear corner are blended.
  const auto clear_corner = [&mesh](const Triangle& t) {
    return mesh.colours[t[0]].a < 1 || mesh.colours[t[1]].a < 1 || mesh.colours[t[2]].a < 1;
  };
  Triangles sorted;
  std::vector<MaterialBlock> blocks;
  for (std::vector<Run>* runs : {&solid_, &translucent_, &creases_}) runs->clear();
  for (const view::MaterialRange& range : mesh.ranges) {
    AUCAST_CHECK(range.triangle_begin <= mesh.triangles.size());
    AUCAST_CHECK(range.triangle_count <= mesh.triangles.size() - range.triangle_begin);
    const bool crease = range.material.shader == Shader::Crease;
    for (const bool blended : {false, true}) {
      const std::size_t first = sorted.size();
      for (const Triangle& triangle :
           mesh.triangles.subspan(range.triangle_begin, range.triangle_count)) {
        const bool clear = !crease && range.translucent && clear_corner(triangle);
        if (clear == blended) sorted.push_back(triangle);
      }
      const std::size_t count = sorted.size() - first;
      if (count == 0) continue;
      (crease    ? creases_
       : blended ? translucent_
                 : solid_)
          .push_back({range.material, blocks.size(), crease ? range.crease : range.eye,
                      range.rounded, 3 * first, static_cast<GLsizei>(3 * count)});
    }
    blocks.push_back(block_of(range.material, !mesh.rest.empty()));
  }
  std::stable_sort(solid_.begin(), solid_.end(),
                   [](const Run& a, const Run& b) { return a.material.order < b.material.order; });
  if (!blocks.empty()) materials_.set(blocks);
  return sorted;
}

/// Appends the rounded triangles of the solid runs that ask for it, and points these runs there.
void MeshBuffers::round_off(std::span<const glm::vec3> rest, Triangles& triangles) {
  plain_ = solid_;
  Triangles corners;
  for (const Run& run : plain_) {
    if (!run.rounded || rest.empty()) continue;
    const auto begin = triangles.begin() + static_cast<std::ptrdiff_t>(run.first_index / 3);
    corners.insert(corners.end(), begin, begin + run.index_count / 3);
  }
  std::vector<glm::vec3> places(rest.begin(), rest.end());
  places.resize(vertex_count_);
  rounded_ = view::RoundedMesh(places, corners, kLeastBend);
  std::size_t given = 0;
  for (Run& run : solid_) {
    if (!run.rounded || rest.empty()) continue;
    const std::size_t before = rounded_.rounded_count(given);
    given += static_cast<std::size_t>(run.index_count / 3);
    run.first_index = 3 * (triangles.size() + before);
    run.index_count = static_cast<GLsizei>(3 * (rounded_.rounded_count(given) - before));
  }
  triangles.insert(triangles.end(), rounded_.triangles().begin(), rounded_.triangles().end());
}

/// An edge between two triangles is drawn twice, as OpenGL does with outlined triangles.
void MeshBuffers::load_edges(std::span<const Triangle> triangles) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const Run& run : plain_) {
    const auto count = static_cast<std::size_t>(run.index_count / 3);
    for (const auto& [a, b, c] : triangles.subspan(run.first_index / 3, count)) {
      edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
    }
  }
  edge_ends_ = static_cast<GLsizei>(2 * edges.size());
  upload(GL_ELEMENT_ARRAY_BUFFER, edges_, std::span<const std::array<std::uint32_t, 2>>(edges),
         GL_STATIC_DRAW);
}

void MeshBuffers::draw_edges() const {
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, edges_.id());
  glDrawElements(GL_LINES, edge_ends_, GL_UNSIGNED_INT, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
}

void MeshBuffers::load(const view::StaticMesh& mesh) {
  vertex_count_ = mesh.colours.size();
  AUCAST_CHECK(mesh.occlusion.size() == vertex_count_);
  AUCAST_CHECK(mesh.gloss.size() == vertex_count_);
  Triangles triangles = sort_into_runs(mesh);
  round_off(mesh.rest, triangles);
  strands_ = view::Strands(mesh, rounded_.vertex_count());

  std::vector<glm::vec2> occlusion_gloss(vertex_count_);
  for (std::size_t i = 0; i < vertex_count_; ++i) {
    occlusion_gloss[i] = {mesh.occlusion[i], mesh.gloss[i]};
  }
  auto grain_places = SkinGrain::places(mesh.rest, mesh.gloss);
  grain_places.resize(vertex_count_);
  const auto upload_once = [this]<typename T>(const Buffer& buffer, std::span<const T> own) {
    const std::vector<T> all = rounded_.with_edges(own);
    upload(GL_ARRAY_BUFFER, buffer, std::span<const T>(all), GL_STATIC_DRAW);
  };
  glBindVertexArray(array_.id());
  upload_once(colours_, mesh.colours);
  upload_once(occlusion_gloss_, std::span<const glm::vec2>(occlusion_gloss));
  upload_once(grain_places_, std::span<const glm::vec2>(grain_places));
  if (!is_desktop_gl()) load_edges(triangles);
  upload(GL_ELEMENT_ARRAY_BUFFER, indices_, std::span<const Triangle>(triangles), GL_STATIC_DRAW);
}

void MeshBuffers::place(const view::MovingMesh& mesh) {
  AUCAST_CHECK(mesh.positions.size() == vertex_count_);
  AUCAST_CHECK(mesh.normals.size() == vertex_count_);
  rounded_.place(mesh.positions, mesh.normals);
  upload(GL_ARRAY_BUFFER, positions_, rounded_.positions(), GL_STREAM_DRAW);
  upload(GL_ARRAY_BUFFER, normals_, rounded_.normals(), GL_STREAM_DRAW);
  upload(GL_ARRAY_BUFFER, strand_ways_, strands_.place(mesh.positions), GL_STREAM_DRAW);
}

}  // namespace aucast::render
