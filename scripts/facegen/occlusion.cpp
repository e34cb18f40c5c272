#include "scripts/facegen/occlusion.h"

#include <array>
#include <limits>
#include <numeric>

namespace aucast::facegen {
namespace {

/// The most nodes that a ray has yet to visit: one for each level of the tree. Each level halves
/// the triangles, whose number has 64 bits.
constexpr std::size_t kWaitingMax = 64;

struct Triangle {
  Vec3 a;
  Vec3 b;
  Vec3 c;
};

struct Box {
  Vec3 low{std::numeric_limits<double>::max()};
  Vec3 high{std::numeric_limits<double>::lowest()};

  void take_in(const Vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }

  [[nodiscard]] bool crosses(const Vec3& origin, const Vec3& inverse, double near,
                             double far) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double t0 = (low[axis] - origin[axis]) * inverse[axis];
      const double t1 = (high[axis] - origin[axis]) * inverse[axis];
      near = std::max(near, std::min(t0, t1));
      far = std::min(far, std::max(t0, t1));
    }
    return near <= far;
  }
};

/// Möller and Trumbore's test, both sides.
bool crosses(const Triangle& t, const Vec3& origin, const Vec3& direction, double near,
             double far) {
  const Vec3 edge1 = t.b - t.a;
  const Vec3 edge2 = t.c - t.a;
  const Vec3 p = glm::cross(direction, edge2);
  const double determinant = glm::dot(edge1, p);
  if (std::abs(determinant) < 1e-9) return false;
  const Vec3 s = origin - t.a;
  const double u = glm::dot(s, p) / determinant;
  if (u < 0 || u > 1) return false;
  const Vec3 q = glm::cross(s, edge1);
  const double v = glm::dot(direction, q) / determinant;
  if (v < 0 || u + v > 1) return false;
  const double way = glm::dot(edge2, q) / determinant;
  return way > near && way < far;
}

}  // namespace

struct RayScene::Tree {
  struct Node {
    Box box;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t left = 0;  ///< 0: a leaf
    std::size_t right = 0;
  };

  std::vector<Triangle> triangles;
  std::vector<Node> nodes;

  std::size_t build(std::size_t begin, std::size_t end) {
    constexpr std::size_t kLeafSize = 4;
    Node node;
    node.begin = begin;
    node.end = end;
    for (std::size_t i = begin; i < end; ++i) {
      for (const Vec3& p : {triangles[i].a, triangles[i].b, triangles[i].c}) node.box.take_in(p);
    }
    const std::size_t me = nodes.size();
    nodes.push_back(node);
    if (end - begin <= kLeafSize) return me;
    const Vec3 size = node.box.high - node.box.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const auto middle = [&](const Triangle& t) { return t.a[axis] + t.b[axis] + t.c[axis]; };
    const std::size_t half = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) {
      return triangles.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(begin), at(half), at(end),
                     [&](const Triangle& x, const Triangle& y) { return middle(x) < middle(y); });
    const std::size_t left = build(begin, half);
    const std::size_t right = build(half, end);
    nodes[me].left = left;
    nodes[me].right = right;
    return me;
  }
};

RayScene::RayScene(std::span<const Part* const> parts) : tree_(std::make_unique<Tree>()) {
  for (const Part* part : parts) {
    for (const face::Polygon& polygon : part->polygons) {
      const auto vertex = [&](std::size_t k) { return part->vertices[polygon.corners[k]]; };
      // What thins out lets the light through.
      if (vertex(0).alpha < 1 || vertex(2).alpha < 1) continue;
      const auto at = [&](std::size_t k) { return vertex(k).position; };
      tree_->triangles.push_back({at(0), at(1), at(2)});
      if (polygon.corner_count == 4) tree_->triangles.push_back({at(0), at(2), at(3)});
    }
  }
  tree_->build(0, tree_->triangles.size());
}

RayScene::~RayScene() = default;

bool RayScene::hit(const Vec3& origin, const Vec3& direction, double near, double far) const {
  const Vec3 inverse{1 / direction.x, 1 / direction.y, 1 / direction.z};
  std::array<std::size_t, kWaitingMax> waiting{};
  std::size_t count = 1;
  while (count > 0) {
    const Tree::Node& node = tree_->nodes[waiting[--count]];
    if (!node.box.crosses(origin, inverse, near, far)) continue;
    if (node.left != 0) {
      waiting[count++] = node.left;
      waiting[count++] = node.right;
      continue;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      if (crosses(tree_->triangles[i], origin, direction, near, far)) return true;
    }
  }
  return false;
}

namespace {

/// Directions over the half space about +z, more of them upright (cosine-weighted), on a spiral.
std::vector<Vec3> hemisphere(int rays) {
  constexpr double kGoldenAngle = 2.399963;
  std::vector<Vec3> directions;
  for (int i = 0; i < rays; ++i) {
    const double u = (i + 0.5) / rays;
    const double r = std::sqrt(u);
    directions.emplace_back(r * std::cos(i * kGoldenAngle), r * std::sin(i * kGoldenAngle),
                            std::sqrt(1 - u));
  }
  return directions;
}

/// Half of each vertex' value from its neighbours; without this the quads show.
void smooth(Part& part) {
  const std::vector<double> means = means_of_neighbours(part, &Vertex::occlusion);
  for (std::size_t i = 0; i < means.size(); ++i) {
    part.vertices[i].occlusion = mix(part.vertices[i].occlusion, means[i], 0.5);
  }
}

}  // namespace

void bake_occlusion(Part& part, const RayScene& occluders, const OcclusionOptions& options) {
  constexpr double kOffSurface = 0.02;
  const std::vector<Vec3> directions = hemisphere(options.rays);
  const std::vector<Vec3> normals = normals_of(part);
  for (std::size_t i = 0; i < part.vertices.size(); ++i) {
    const Vec3& n = normals[i];
    const Vec3 other = std::abs(n.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
    const Vec3 x = glm::normalize(glm::cross(other, n));
    const Vec3 y = glm::cross(n, x);
    int hits = 0;
    for (const Vec3& d : directions) {
      const Vec3 world = x * d.x + y * d.y + n * d.z;
      if (occluders.hit(part.vertices[i].position + n * kOffSurface, world, 0.01, options.reach)) {
        ++hits;
      }
    }
    const double open = 1 - static_cast<double>(hits) / options.rays;
    part.vertices[i].occlusion = options.darkest + (1 - options.darkest) * saturate(open * 1.08);
  }
  for (int i = 0; i < options.smoothing; ++i) smooth(part);
}

}  // namespace aucast::facegen
