#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"
#include "client/render/uniform_blocks.h"
#include "client/view/rounded_mesh.h"
#include "client/view/scene.h"
#include "client/view/strands.h"

namespace aucast::render {

/// A run of triangles with one material.
struct Run {
  view::Material material;
  std::size_t block = 0;  ///< index of the material in MeshBuffers::materials()
  int index = -1;         ///< index of the eye or the crease; -1: neither
  bool rounded = false;
  std::size_t first_index = 0;
  GLsizei index_count = 0;

  /// The program must be in use and the mesh's vertices bound.
  void draw() const;
  /// Draws the same vertices as points.
  void draw_points() const;
};

/// A face in OpenGL's memory: its vertices, and its triangles as runs in the order in which they
/// are drawn. Needs a current context as long as it lives.
/// Thread: the one the context is current on.
class MeshBuffers {
 public:
  MeshBuffers();

  void load(const view::StaticMesh& mesh);
  /// Sets where the vertices are. Copies all of them, moved or not: a head that turns moves them
  /// all, and in bench_render placing takes 0.1 % of the processor's time, and all copying of
  /// memory, reading pictures back included, 2 %.
  void place(const view::MovingMesh& mesh);
  /// Binds the vertices; if `textured` is false, all have one plain colour.
  void bind(bool textured) const;
  /// Draws the edges of plain() as lines, but only in OpenGL ES, which cannot draw triangles as
  /// outlines. A program must be in use and the vertices bound.
  void draw_edges() const;

  /// The opaque runs, outermost first.
  [[nodiscard]] const std::vector<Run>& solid() const { return solid_; }
  /// The same runs with the mesh's own triangles, not rounded.
  [[nodiscard]] const std::vector<Run>& plain() const { return plain_; }
  [[nodiscard]] const std::vector<Run>& translucent() const { return translucent_; }
  [[nodiscard]] const std::vector<Run>& creases() const { return creases_; }
  [[nodiscard]] const BlockBuffer<MaterialBlock>& materials() const { return materials_; }

 private:
  using Triangles = std::vector<view::RoundedMesh::Triangle>;

  [[nodiscard]] Triangles sort_into_runs(const view::StaticMesh& mesh);
  void load_edges(std::span<const view::RoundedMesh::Triangle> triangles);
  void round_off(std::span<const glm::vec3> rest, Triangles& triangles);

  VertexArray array_;
  Buffer positions_;
  Buffer normals_;
  Buffer colours_;
  Buffer occlusion_gloss_;
  Buffer grain_places_;
  Buffer strand_ways_;
  Buffer indices_;
  Buffer edges_;
  GLsizei edge_ends_ = 0;
  BlockBuffer<MaterialBlock> materials_;
  std::size_t vertex_count_ = 0;  ///< without the vertices that rounding adds
  view::RoundedMesh rounded_;
  view::Strands strands_;
  std::vector<Run> solid_;
  std::vector<Run> plain_;
  std::vector<Run> translucent_;
  std::vector<Run> creases_;
};

}  // namespace aucast::render
