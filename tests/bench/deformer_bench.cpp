// What a frame of a face costs, as ratios to the plain things beside it: (a) the published loop,
// each muscle over all vertices, and (b) a copy of the same bytes. Usage: bench_deformer [--frames]
// [FACE_FOLDER DATA_FOLDER]; without folders the default face beside the programs; with --frames
// only what the frames cost, which tests/web/deform.mjs compares with the same in a browser. Every
// frame differs from the one before in all channels that are not zero, as in an animation; a frame
// in which nothing changes costs next to nothing, but "rest" shows what looking costs. The loop
// moves every vertex; what the two ways must agree about is what is drawn, and the copy is of the
// whole arrays, as they go to the renderer. Below them what a frame that moves everything is made
// of, and what the least of it costs by itself.

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "client/face/drawn_blocks.h"
#include "client/face/face.h"
#include "client/face/face_deformer.h"
#include "client/face/muscle_sums.h"
#include "client/face/normal_field.h"
#include "common/files.h"
#include "tests/support/displacement.h"

namespace {

using aucast::face::DeformedFace;
using aucast::face::Face;
using aucast::face::FaceDeformer;
using aucast::face::FaceMesh;
using aucast::face::find_map;
using aucast::face::map_at;
using aucast::face::MeshPart;

constexpr int kRounds = 100;
constexpr double kRoundMin = 1'500;  ///< microseconds
constexpr int kColdRounds = 51;
constexpr std::size_t kFrames = 16;

/// What two ways to compute the same may differ by.
constexpr float kApartMax = 1e-4F;
constexpr float kNormalsApartMax = 1e-3F;

/// The time this thread has run: what others do on the machine does not count. Browsers do not tell
/// that; there it is the time that passes.
double thread_microseconds() {
#ifdef __EMSCRIPTEN__
  constexpr clockid_t kClock = CLOCK_MONOTONIC;
#else
  constexpr clockid_t kClock = CLOCK_THREAD_CPUTIME_ID;
#endif
  timespec now{};
  ::clock_gettime(kClock, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
}

/// Microseconds of one call: the best of many short rounds, since a busy machine disturbs long
/// ones. A round is long enough for a browser's clock.
template <typename Call>
double microseconds(Call call) {
  const auto round = [&call](int calls) {
    const double begin = thread_microseconds();
    for (int i = 0; i < calls; ++i) call();
    return thread_microseconds() - begin;
  };
  int calls = 1;
  while (round(calls) < kRoundMin) calls *= 2;
  double best = 1e30;
  for (int i = 0; i < kRounds; ++i) best = std::min(best, round(calls) / calls);
  return best;
}

/// Reads and writes more than any cache holds, so that what comes next is fetched from memory.
void empty_caches() {
  static std::vector<unsigned char> other(std::size_t{128} << 20);
  for (std::size_t i = 0; i < other.size(); i += 64) ++other[i];
}

/// Likewise of one call whose data lie in no cache any more, as in a player that draws and sleeps
/// between two frames. The median: what the caches happen to keep makes some calls cheaper.
template <typename Call>
double cold_microseconds(Call call) {
  std::vector<double> taken;
  for (int round = 0; round < kColdRounds; ++round) {
    empty_caches();
    const double begin = thread_microseconds();
    call();
    taken.push_back(thread_microseconds() - begin);
  }
  std::nth_element(taken.begin(), taken.begin() + kColdRounds / 2, taken.end());
  return taken[kColdRounds / 2];
}

/// The bytes of a frame, copied, drawn or not.
void copy_frame(const DeformedFace& from, DeformedFace& to) {
  std::memcpy(to.positions.data(), from.positions.data(),
              from.positions.size() * sizeof(glm::vec3));
  std::memcpy(to.normals.data(), from.normals.data(), from.normals.size() * sizeof(glm::vec3));
}

/// Turns (u, v) by `angle` with the library's sine and cosine.
void turn(float& u, float& v, float angle, float u0, float v0) {
  const float du = u - u0;
  const float dv = v - v0;
  u = u0 + du * std::cos(angle) + dv * std::sin(angle);
  v = v0 + dv * std::cos(angle) - du * std::sin(angle);
}

/// The published way: for every muscle every vertex, then the jaw and the lids vertex by vertex,
/// then all normals. What the maps say is looked up beforehand, so that only arithmetic is timed.
class PlainFace {
 public:
  explicit PlainFace(const Face& face) : face_(face), masks_(face.muscles.size() + 3) {
    const FaceMesh& mesh = face.mesh;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        const std::string& mask = face.muscles[m].mask;
        const float reach =
            face.muscles[m].mask_alone ? 1.0F : map_at(find_map(mesh, "muscle"), i, 1);
        masks_[m].push_back(reach * (mask.empty() ? 1.0F : map_at(find_map(mesh, mask), i, 1)));
      }
      masks_[face.muscles.size()].push_back(map_at(find_map(mesh, "jaw"), i, 0));
      masks_[face.muscles.size() + 1].push_back(map_at(find_map(mesh, "lid_angle"), i, 0));
      masks_[face.muscles.size() + 2].push_back(map_at(find_map(mesh, "head"), i, 0));
    }
  }

  void deform(const std::vector<float>& activations, DeformedFace& out) const {
    move_muscles(activations, out.positions);
    move_lids_and_jaw(activations, out.positions);
    turn_head(activations, out.positions);
    normals(out);
  }

 private:
  [[nodiscard]] float value(const std::vector<float>& activations, const char* channel) const {
    const auto index = face_.channel_index(channel);
    return index ? activations[*index] : 0.0F;
  }

  /// A muscle that yields to the lid of its side is weaker the more that closes.
  [[nodiscard]] float relaxed(const std::vector<float>& activations, std::size_t muscle) const {
    if (!face_.muscles[muscle].yields_to_lids) return activations[muscle];
    const bool left = face_.channels[muscle].side == aucast::Side::Left;
    const float close = value(activations, left ? "left_lid_close" : "right_lid_close");
    return activations[muscle] * (1 - close * close);
  }

  void move_muscles(const std::vector<float>& activations, std::vector<glm::vec3>& out) const {
    out = face_.mesh.positions;
    for (std::size_t m = 0; m < face_.muscles.size(); ++m) {
      const float activation = relaxed(activations, m);
      const auto* linear = std::get_if<aucast::face::LinearMuscle>(&face_.muscles[m].shape);
      const auto* local = std::get_if<aucast::face::LocalPull>(&face_.muscles[m].shape);
      for (std::size_t i = 0; i < out.size(); ++i) {
        const glm::vec3& rest = face_.mesh.positions[i];
        const glm::vec3 way = linear != nullptr  ? pulled(*linear, rest, activation)
                              : local != nullptr ? pulled(*local, rest, activation)
                                                 : aucast::test::displacement(
                                                       face_.muscles[m].shape, rest, activation);
        out[i] += masks_[m][i] * way;
      }
    }
  }

  /// The published linear muscle, in single precision.
  static glm::vec3 pulled(const aucast::face::LinearMuscle& muscle, const glm::vec3& point,
                          float activation) {
    const glm::vec3 axis = glm::normalize(muscle.insertion - muscle.attachment);
    const glm::vec3 arm = point - muscle.attachment;
    const float distance = glm::length(arm);
    if (distance <= 0 || distance >= muscle.falloff_finish) return glm::vec3(0);
    const float cos_zone = std::cos(muscle.zone_rad);
    const float cos_angle = glm::dot(arm, axis) / distance;
    if (cos_angle <= cos_zone) return glm::vec3(0);
    const float gain = 1 / cos_zone - 1;
    const float radial = distance < muscle.falloff_start
                             ? 1.0F
                             : std::cos((distance - muscle.falloff_start) /
                                        (muscle.falloff_finish - muscle.falloff_start) *
                                        std::numbers::pi_v<float> / 2);
    const float pull = muscle.cap ? std::min(activation * gain, *muscle.cap) : activation * gain;
    return -arm * (pull * (cos_angle - cos_zone) / (1 - cos_zone) * radial);
  }

  /// Our local pull, in single precision and with nothing computed outside its radii.
  static glm::vec3 pulled(const aucast::face::LocalPull& muscle, const glm::vec3& point,
                          float activation) {
    const glm::vec3 scaled = (point - muscle.centre) / muscle.radii;
    const float squared = glm::dot(scaled, scaled);
    if (squared >= 9) return glm::vec3(0);
    const float edge = std::exp(-9.0F);
    return muscle.direction * (activation * (std::exp(-squared) - edge) / (1 - edge));
  }

  void move_lids_and_jaw(const std::vector<float>& activations, std::vector<glm::vec3>& out) const {
    const float rad = std::numbers::pi_v<float> / 180;
    const std::size_t jaw_row = face_.muscles.size();
    for (const auto& eye : face_.eyes) {
      const bool left = eye.centre.x > 0;
      const float raise = value(activations, left ? "left_lid_raise" : "right_lid_raise");
      const float closure = value(activations, left ? "left_lid_close" : "right_lid_close") -
                            (face_.lids ? face_.lids->raised(raise) : 0);
      for (std::size_t i = 0; i < out.size(); ++i) {
        const float angle = masks_[jaw_row + 1][i];
        if (angle == 0 || (face_.mesh.positions[i].x >= 0) != left) continue;
        turn(out[i].y, out[i].z, -angle * closure, eye.centre.y, eye.centre.z);
      }
    }
    if (!face_.jaw) return;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const float angle =
          rad * face_.jaw->degrees_per_unit * value(activations, "jaw") * masks_[jaw_row][i];
      if (angle == 0) continue;
      turn(out[i].y, out[i].z, -angle, face_.jaw->hinge.y, face_.jaw->hinge.z);
      out[i].z += face_.jaw->forward_per_rad * angle;
    }
  }

  void turn_head(const std::vector<float>& activations, std::vector<glm::vec3>& out) const {
    if (!face_.head) return;
    const float rad = std::numbers::pi_v<float> / 180;
    const float angle = rad * face_.head->turn_deg * value(activations, "head_turn_left");
    if (angle == 0) return;
    for (std::size_t i = 0; i < out.size(); ++i) {
      turn(out[i].x, out[i].z, angle * masks_[face_.muscles.size() + 2][i], face_.head->pivot.x,
           face_.head->pivot.z);
    }
  }

  void normals(DeformedFace& out) const {
    out.normals.assign(out.positions.size(), glm::vec3(0));
    for (const auto& [a, b, c] : face_.mesh.triangles) {
      const glm::vec3 normal =
          glm::cross(out.positions[b] - out.positions[a], out.positions[c] - out.positions[a]);
      out.normals[a] += normal;
      out.normals[b] += normal;
      out.normals[c] += normal;
    }
    for (glm::vec3& normal : out.normals) {
      const float length = glm::length(normal);
      normal = length > 0 ? normal / length : glm::vec3(0, 0, 1);
    }
  }

  const Face& face_;
  std::vector<std::vector<float>> masks_;
};

/// Between what is drawn: not of creases of depth 0.
float largest_difference(const FaceMesh& mesh, const DeformedFace& ours,
                         const DeformedFace& theirs) {
  float largest = 0;
  std::size_t crease = 0;
  for (const MeshPart& part : mesh.parts) {
    if (is_crease(part) && !(ours.creases[crease++] > 0)) continue;
    for (std::size_t i = part.vertex_begin; i < part.vertex_begin + part.vertex_count; ++i) {
      largest = std::max(largest, glm::distance(ours.positions[i], theirs.positions[i]));
    }
  }
  return largest;
}

/// Likewise for normals, which no crease has. Where triangles lie against each other their areas
/// cancel, and slivers have hardly any: there the last digits of the corners decide the normal. It
/// counts by how much area is left, beside all there is and beside what corners change that are
/// 1e-5 elsewhere.
float largest_difference_of_normals(const FaceMesh& mesh, const DeformedFace& a,
                                    const DeformedFace& b) {
  const std::vector<bool> of_crease = aucast::face::crease_vertices(mesh);
  std::vector<glm::vec3> sums(a.positions.size(), glm::vec3(0));
  std::vector<float> areas(a.positions.size(), 0.0F);
  for (const auto& triangle : mesh.triangles) {
    const glm::vec3& corner = a.positions[triangle[0]];
    const glm::vec3 u = a.positions[triangle[1]] - corner;
    const glm::vec3 v = a.positions[triangle[2]] - corner;
    const glm::vec3 area = glm::cross(u, v);
    for (const std::uint32_t vertex : triangle) {
      sums[vertex] += area;
      areas[vertex] +=
          glm::length(area) + 1e-5F / kNormalsApartMax * (glm::length(u) + glm::length(v));
    }
  }
  float largest = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (of_crease[i] || !(areas[i] > 0)) continue;
    const float left = glm::length(sums[i]) / areas[i];
    largest = std::max(largest, left * glm::distance(a.normals[i], b.normals[i]));
  }
  return largest;
}

using Frames = std::vector<std::vector<float>>;

/// An animation about one set of activations: every frame has all of them a little different from
/// the frame before.
Frames animation(const std::vector<float>& activations) {
  Frames frames(kFrames, activations);
  for (std::size_t f = 0; f < kFrames; ++f) {
    const float strength = 1 - 0.1F * static_cast<float>(f) / kFrames;
    for (float& activation : frames[f]) activation *= strength;
  }
  return frames;
}

/// Likewise, but one of the muscles begins to act in every second frame and ends in the others.
Frames begins_and_ends(const std::vector<float>& activations) {
  Frames frames = animation(activations);
  std::size_t muscle = 0;
  while (muscle < activations.size() && activations[muscle] == 0) ++muscle;
  if (muscle == activations.size()) return frames;
  for (std::size_t f = 1; f < kFrames; f += 2) frames[f][muscle] = 0;
  return frames;
}

/// Times an animation, its frames alone if `briefly`. False when the two ways disagree.
bool compare(const char* title, const Face& face, const Frames& frames, bool briefly) {
  FaceDeformer deformer(face);
  const PlainFace plain(face);
  DeformedFace theirs;
  float apart = 0;
  float normals_apart = 0;
  for (const std::vector<float>& frame : frames) {
    const DeformedFace& ours = deformer.deform(frame);
    plain.deform(frame, theirs);
    apart = std::max(apart, largest_difference(face.mesh, ours, theirs));
    normals_apart = std::max(normals_apart, largest_difference_of_normals(face.mesh, ours, theirs));
  }
  std::size_t number = 0;
  const auto next = [&]() -> const std::vector<float>& { return frames[number++ % kFrames]; };
  const double frame = microseconds([&] { deformer.deform(next()); });
  const bool agree = apart < kApartMax && normals_apart < kNormalsApartMax;
  if (briefly) {
    std::printf("%-30s %8.2f us\n", title, frame);
    return agree;
  }
  const double loop = microseconds([&] { plain.deform(next(), theirs); });
  const DeformedFace& ours = deformer.deform(next());
  const auto copy_once = [&] { copy_frame(ours, theirs); };
  const double copy = microseconds(copy_once);
  const double cold_frame = cold_microseconds([&] { deformer.deform(next()); });
  const double cold_copy = cold_microseconds(copy_once);
  std::printf(
      "%-30s %8.2f us  loop %9.2f us  copy %6.2f us  %6.1fx over the loop, %5.1fx a copy; "
      "cold %6.1f us, copy %5.1f us, %4.1fx  apart %.1e, normals %.1e\n",
      title, frame, loop, copy, loop / frame, frame / copy, cold_frame, cold_copy,
      cold_frame / cold_copy, static_cast<double>(apart), static_cast<double>(normals_apart));
  return agree;
}

/// The numbers of each vertex's neighbours, one list after the other.
struct Neighbours {
  explicit Neighbours(const FaceMesh& mesh) {
    std::vector<std::vector<std::uint32_t>> lists(mesh.positions.size());
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t one : triangle) {
        for (const std::uint32_t other : triangle) {
          if (one != other) lists[one].push_back(other);
        }
      }
    }
    for (auto& list : lists) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      numbers.insert(numbers.end(), list.begin(), list.end());
      begin.push_back(numbers.size());
    }
  }
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> numbers;
};

/// What bounds a frame that moves every vertex: its parts one by one, each over the whole mesh, and
/// the least that normals can do, to fetch each vertex's neighbours.
void show_parts(const Face& face) {
  using aucast::face::Four;
  const std::size_t blocks = aucast::face::block_count(face.mesh.positions.size());
  aucast::face::MuscleSums sums(face);
  aucast::face::NormalField field(face.mesh);
  aucast::face::BlockSet all(blocks);
  for (std::size_t block = 0; block < blocks; ++block) all.insert(block);
  sums.take(std::vector<float>(face.channels.size(), 0.5F), all);
  sums.list(all);
  std::vector<aucast::face::VertexBlock> now(blocks);
  DeformedFace out;
  out.positions = out.normals = face.mesh.positions;
  DeformedFace copied = out;
  const double copy = microseconds([&] { copy_frame(out, copied); });
  const auto show = [&](const char* title, double time) {
    std::printf("  %-44s %8.2f us, %5.1fx a copy\n", title, time, time / copy);
  };
  std::printf("parts of a frame that moves every vertex:\n");
  show("all muscles' displacements, only added up",
       microseconds([&] { all.for_each([&](std::size_t block) { sums.at(block, now[block]); }); }));
  show("positions, only written", microseconds([&] {
         all.for_each([&](std::size_t block) {
           const auto points = aucast::face::points_of(now[block]);
           field.place(block, points);
           aucast::face::write_points(points, aucast::face::block_of(out.positions, block));
         });
       }));
  show("normals", microseconds([&] { field.update(all, out.normals); }));
  const Neighbours neighbours(face.mesh);
  std::vector<Four> points(out.positions.size());
  std::vector<Four> added(out.positions.size());
  show("neighbours, only fetched and added up", microseconds([&] {
         for (std::size_t i = 0; i < added.size(); ++i) {
           Four sum{};
           for (std::size_t k = neighbours.begin[i]; k < neighbours.begin[i + 1]; ++k) {
             sum += points[neighbours.numbers[k]];
           }
           added[i] = sum;
         }
       }));
}

}  // namespace

int main(int argc, char** argv) {
  const bool briefly = argc > 1 && std::string_view(argv[1]) == "--frames";
  if (briefly) --argc, ++argv;
  const auto data = aucast::find_data_folder(argc > 2 ? argv[2] : "");
  if (!data) return std::fprintf(stderr, "%s\n", data.error().message.c_str()), 4;
  const std::filesystem::path folder = argc > 1 ? argv[1] : (*data / "faces" / "default").string();
  const auto face = aucast::face::load_face(folder, *data);
  if (!face) return std::fprintf(stderr, "%s\n", face.error().message.c_str()), 3;
  std::printf("%s: %zu vertices, %zu triangles, %zu muscles, %zu channels\n", face->name.c_str(),
              face->mesh.positions.size(), face->mesh.triangles.size(), face->muscles.size(),
              face->channels.size());

  const std::vector<float> nothing(face->channels.size(), 0.0F);
  std::vector<float> muscles = nothing;
  std::fill_n(muscles.begin(), face->muscles.size(), 0.5F);
  std::vector<float> expression = muscles;
  for (const auto* name : {"jaw", "left_lid_close", "right_lid_close"}) {
    if (const auto channel = face->channel_index(name)) expression[*channel] = 0.5F;
  }
  std::vector<float> turning = nothing;
  std::vector<float> everything = expression;
  if (const auto channel = face->channel_index("head_turn_left")) {
    turning[*channel] = everything[*channel] = 0.5F;
  }
  std::vector<float> smile = nothing;
  if (const auto recording = face->recordings.find(12); recording != face->recordings.end()) {
    smile = recording->second.activation;
  }
  std::vector<float> lined = expression;
  for (const MeshPart& part : face->mesh.parts) {
    if (is_crease(part)) lined.at(*face->channel_index(part.name)) = 1;
  }
  const std::pair<const char*, Frames> rows[] = {
      {"rest", animation(nothing)},
      {"AU 12", animation(smile)},
      {"AU 12, a muscle begins or ends", begins_and_ends(smile)},
      {"all muscles", animation(muscles)},
      {"all muscles, jaw, lids", animation(expression)},
      {"  and all creases", animation(lined)},
      {"the head alone", animation(turning)},
      {"muscles, jaw, lids and head", animation(everything)},
  };
  bool agree = true;
  for (const auto& [title, frames] : rows) agree = compare(title, *face, frames, briefly) && agree;
  if (!briefly) show_parts(*face);
  if (!agree) std::fprintf(stderr, "the two ways disagree\n");
  return agree ? 0 : 1;
}
