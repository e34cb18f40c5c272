#include "client/face/normal_field.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "client/face/drawn_blocks.h"

namespace aucast::face {
namespace {

constexpr std::size_t kHalf = kLanes / 2;

/// How many blocks have their areas added up before any of them is made a normal, so that the
/// square roots need not wait.
constexpr std::size_t kBlocksAtOnce = 16;

/// Triangles or vertices of one portion.
constexpr std::size_t kAtOnce = 2000;

/// The triangles that take light.
std::vector<std::array<std::uint32_t, 3>> lit_triangles(const FaceMesh& mesh) {
  const std::vector<bool> crease = crease_vertices(mesh);
  auto triangles = mesh.triangles;
  std::erase_if(triangles, [&](const auto& triangle) { return crease[triangle[0]]; });
  return triangles;
}

/// The edges round one vertex: each triangle's edge opposite the vertex, from corner to corner.
using Ring = std::multimap<std::uint32_t, std::uint32_t>;

/// Takes the edges that follow each other from `start` on, until none follows or the path is
/// closed.
std::vector<std::uint32_t> take_path(Ring& ring, std::uint32_t start) {
  std::vector<std::uint32_t> path{start};
  do {
    const auto edge = ring.lower_bound(path.back());
    if (edge == ring.end() || edge->first != path.back()) break;
    path.push_back(edge->second);
    ring.erase(edge);
  } while (path.back() != start);
  return path;
}

/// The corner at which a path begins that is not closed; if all are, any.
std::uint32_t open_end(const Ring& ring) {
  std::map<std::uint32_t, int> surplus;
  for (const auto& [from, to] : ring) {
    ++surplus[from];
    --surplus[to];
  }
  const auto found = std::find_if(surplus.begin(), surplus.end(),
                                  [](const auto& corner) { return corner.second > 0; });
  return found == surplus.end() ? ring.begin()->first : found->first;
}

/// The corners that add up to the area of the triangles round `vertex`: an even number, in the
/// order that NormalField describes.
std::vector<std::uint32_t> corners_round(std::uint32_t vertex, Ring ring) {
  std::vector<std::uint32_t> corners;
  while (!ring.empty()) {
    std::vector<std::uint32_t> path = take_path(ring, open_end(ring));
    if (path.back() != path.front()) {
      path.push_back(vertex);
      path.push_back(path.front());
    }
    if (corners.empty()) {
      // Seen from the first corner the last edge, back to it, has no area.
      path.pop_back();
    } else {
      // Over to the next polygon without an area.
      corners.push_back(corners[0]);
    }
    corners.insert(corners.end(), path.begin(), path.end());
    if (corners.size() % 2 == 1) corners.push_back(corners.back());
  }
  if (corners.empty()) corners = {vertex, vertex};
  return corners;
}

/// Two more corners that add no area.
void stay(std::vector<std::uint32_t>& corners) {
  corners.insert(corners.end(), {corners.front(), corners.back()});
}

Four yzx(Four v) {
  return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}

/// Twice the area of the quadrangle from `first` over `last` and two more corners, as a vector
/// along its normal with its coordinates turned: (z, x, y). `last` goes on to the last of them.
Four area(const Four* points, const std::uint32_t* corners, const Four& first, Four& last) {
  const Four next = at_distance(points, corners[1]);
  const Four u = at_distance(points, corners[0]) - first;
  const Four v = next - last;
  last = next;
  return u * yzx(v) - yzx(u) * v;
}

Four square_roots(Four v) {
  // One by one and not in a loop, which Clang 14 sends through memory: it, too, makes one
  // instruction of this.
  return Four{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
}

/// Four sums of areas, brought to unit length.
void write_normals(const Four* sums, glm::vec3* out) {
  // The coordinates side by side, so that the square roots are taken together.
  const Four zx01 = __builtin_shufflevector(sums[0], sums[1], 0, 4, 1, 5);
  const Four zx23 = __builtin_shufflevector(sums[2], sums[3], 0, 4, 1, 5);
  const Four y01 = __builtin_shufflevector(sums[0], sums[1], 2, 6, 3, 7);
  const Four y23 = __builtin_shufflevector(sums[2], sums[3], 2, 6, 3, 7);
  Four x = __builtin_shufflevector(zx01, zx23, 2, 3, 6, 7);
  Four y = __builtin_shufflevector(y01, y23, 0, 1, 4, 5);
  Four z = __builtin_shufflevector(zx01, zx23, 0, 1, 4, 5);
  const Four squared = x * x + y * y + z * z;
  const Four inverse = 1 / square_roots(squared);
  const auto has_area = squared > 0;
  x = has_area ? x * inverse : Four{};
  y = has_area ? y * inverse : Four{};
  z = has_area ? z * inverse : Four{1, 1, 1, 1};
  const Four x02y02 = __builtin_shufflevector(x, y, 0, 2, 4, 6);
  const Four y13z13 = __builtin_shufflevector(y, z, 1, 3, 5, 7);
  const Four z02x13 = __builtin_shufflevector(z, x, 0, 2, 5, 7);
  const std::array<Four, 3> packed{__builtin_shufflevector(x02y02, z02x13, 0, 2, 4, 6),
                                   __builtin_shufflevector(y13z13, x02y02, 0, 2, 5, 7),
                                   __builtin_shufflevector(z02x13, y13z13, 1, 3, 5, 7)};
  std::memcpy(&out->x, packed.data(), sizeof packed);
}

}  // namespace

NormalField::NormalField(const FaceMesh& mesh) {
  Making making(mesh);
  while (!making.step()) {
  }
  *this = making.finish();
}

struct NormalField::Making::State {
  explicit State(const FaceMesh& mesh);

  void note(const std::array<std::uint32_t, 3>& triangle);
  void list_corners(std::size_t half);
  void list_neighbours();

  const FaceMesh& mesh;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t noted = 0;    ///< triangles
  std::size_t listed = 0;   ///< half blocks
  std::vector<Ring> rings;  ///< one per vertex
  std::vector<std::map<std::size_t, std::uint64_t>> near_block;
  NormalField field;
};

NormalField::Making::State::State(const FaceMesh& driven)
    : mesh(driven),
      triangles(lit_triangles(driven)),
      rings(kLanes * block_count(driven.positions.size())),
      near_block(block_count(driven.positions.size())) {
  field.points_.resize(rings.size());
  field.touched_ = BlockSet(near_block.size());
  always_drawn(mesh).for_each([&](std::size_t block) {
    near_block[block][block / BlockSet::kWordBits] = BlockSet::bit(block);
  });
}

void NormalField::Making::State::note(const std::array<std::uint32_t, 3>& triangle) {
  for (const std::uint32_t one : triangle) {
    for (const std::uint32_t other : triangle) {
      const std::size_t block = other / kLanes;
      near_block[one / kLanes][block / BlockSet::kWordBits] |= BlockSet::bit(block);
    }
  }
  const auto& [a, b, c] = triangle;
  if (a == b || b == c || c == a) return;
  rings[a].emplace(b, c);
  rings[b].emplace(c, a);
  rings[c].emplace(a, b);
}

void NormalField::Making::State::list_corners(std::size_t half) {
  std::array<std::vector<std::uint32_t>, kHalf> of_four;
  std::size_t most = 0;
  for (std::size_t i = 0; i < kHalf; ++i) {
    const std::size_t vertex = half * kHalf + i;
    of_four[i] = corners_round(static_cast<std::uint32_t>(vertex), std::move(rings[vertex]));
    most = std::max(most, of_four[i].size());
  }
  for (auto& corners : of_four) {
    while (corners.size() < most) stay(corners);
  }
  for (std::size_t k = 0; k < most; k += 2) {
    for (const auto& corners : of_four) {
      for (const std::size_t i : {k, k + 1}) {
        field.corners_.push_back(static_cast<std::uint32_t>(sizeof(Four) * corners[i]));
      }
    }
  }
  field.corners_begin_.push_back(static_cast<std::uint32_t>(field.corners_.size()));
}

void NormalField::Making::State::list_neighbours() {
  for (const auto& words : near_block) {
    for (const auto& [word, bits] : words) field.neighbours_.push_back({word, bits});
    field.neighbours_begin_.push_back(static_cast<std::uint32_t>(field.neighbours_.size()));
  }
}

NormalField::Making::Making(const FaceMesh& mesh) : state_(std::make_unique<State>(mesh)) {}
NormalField::Making::~Making() = default;

bool NormalField::Making::step() {
  State& s = *state_;
  const std::size_t halves = s.rings.size() / kHalf;
  if (s.noted < s.triangles.size()) {
    const std::size_t until = std::min(s.noted + kAtOnce, s.triangles.size());
    while (s.noted < until) s.note(s.triangles[s.noted++]);
  } else {
    const std::size_t until = std::min(s.listed + kAtOnce / kHalf, halves);
    while (s.listed < until) s.list_corners(s.listed++);
  }
  return s.noted == s.triangles.size() && s.listed == halves;
}

NormalField NormalField::Making::finish() {
  state_->list_neighbours();
  NormalField field = std::move(state_->field);
  const std::vector<VertexBlock> rest = blocks_of(state_->mesh.positions);
  for (std::size_t block = 0; block < rest.size(); ++block) {
    field.place(block, points_of(rest[block]));
  }
  return field;
}

void NormalField::add_areas(std::size_t half, Four* sums) const {
  const Four* const points = points_.data();
  const std::uint32_t* corners = &corners_[corners_begin_[half]];
  const std::uint32_t* const end = corners_.data() + corners_begin_[half + 1];
  const Four first0 = at_distance(points, corners[0]);
  const Four first1 = at_distance(points, corners[2]);
  const Four first2 = at_distance(points, corners[4]);
  const Four first3 = at_distance(points, corners[6]);
  Four last0 = at_distance(points, corners[1]);
  Four last1 = at_distance(points, corners[3]);
  Four last2 = at_distance(points, corners[5]);
  Four last3 = at_distance(points, corners[7]);
  Four sum0{};
  Four sum1{};
  Four sum2{};
  Four sum3{};
  for (corners += 2 * kHalf; corners != end; corners += 2 * kHalf) {
    sum0 += area(points, corners, first0, last0);
    sum1 += area(points, corners + 2, first1, last1);
    sum2 += area(points, corners + 4, first2, last2);
    sum3 += area(points, corners + 6, first3, last3);
  }
  sums[0] = sum0;
  sums[1] = sum1;
  sums[2] = sum2;
  sums[3] = sum3;
}

void NormalField::update_some(std::span<const std::size_t> blocks,
                              std::span<glm::vec3> normals) const {
  std::array<Four, kBlocksAtOnce * kLanes> sums;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    add_areas(2 * blocks[i], &sums[i * kLanes]);
    add_areas(2 * blocks[i] + 1, &sums[i * kLanes + kHalf]);
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    write_block(block_of(normals, blocks[i]), [&](glm::vec3* out) {
      write_normals(&sums[i * kLanes], out);
      write_normals(&sums[i * kLanes + kHalf], out + kHalf);
    });
  }
}

void NormalField::touch(const BlockSet& moved) {
  if (moved == moved_) return;  // as from frame to frame of one expression
  moved_ = moved;
  touched_.clear();
  moved.for_each([&](std::size_t block) {
    for (std::uint32_t i = neighbours_begin_[block]; i < neighbours_begin_[block + 1]; ++i) {
      touched_.insert(neighbours_[i].word, neighbours_[i].bits);
    }
  });
}

void NormalField::update(const BlockSet& moved, std::span<glm::vec3> normals) {
  touch(moved);
  std::array<std::size_t, kBlocksAtOnce> some;
  std::size_t count = 0;
  touched_.for_each([&](std::size_t block) {
    some[count++] = block;
    if (count < some.size()) return;
    update_some(some, normals);
    count = 0;
  });
  update_some(std::span(some).first(count), normals);
}

}  // namespace aucast::face
