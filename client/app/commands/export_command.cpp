#include "client/app/commands/export_command.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <vector>

#include "client/app/assets.h"
#include "client/app/window/composition_file.h"
#include "client/face/muscle_mixer.h"
#include "client/glb/drift.h"
#include "client/glb/face_glb.h"
#include "client/glb/motion.h"
#include "client/sound/file_track.h"
#include "common/files.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/limits.h"

namespace aucast::app {
namespace {

constexpr int kFps = 30;
/// Nine hours at 30 a second: 110 MB of weights.
constexpr std::size_t kMomentsMax = 1'000'000;
/// Moments, or faces without a stream, of which the error is measured.
constexpr std::size_t kMeasuredMax = 2000;
constexpr std::size_t kRandomFaces = 200;
constexpr std::uint64_t kRandomSeed = 1;

glb::Sampling sampling_of(const PlayerOptions& options) {
  return {.fps = options.output.fps.value_or(kFps),
          .untimed = options.playback.speed.value_or(protocol::kDefaultKeyframeTime),
          .interpolation = options.playback.interpolation,
          .idle = {options.playback.idle_seed, options.playback.blink}};
}

/// What the stream asks for and the face cannot show, once.
void warn_of_missing(const face::Face& face, const std::vector<playback::TimedAus>& keyframes) {
  AuFrame all;
  for (const playback::TimedAus& keyframe : keyframes) {
    for (std::size_t i = 0; i < all.left.size(); ++i) {
      all.left[i] = std::max(all.left[i], keyframe.aus.left[i]);
      all.right[i] = std::max(all.right[i], keyframe.aus.right[i]);
    }
  }
  if (const std::string missing = face::not_shown(face, all); !missing.empty()) {
    spdlog::warn("the face '{}' cannot show AU {}", face.name, missing);
  }
}

/// Those of data/ are the project's own.
std::string licence_of(const Assets& assets) {
  return assets.face_folder.parent_path() == assets.data_folder / "faces" ? "MIT licence, AUcast"
                                                                          : "";
}

void print_summary(const ExportOptions& given, std::size_t bytes, const glb::MorphTargets& targets,
                   const glb::Motion* motion, const glb::Drift::Summary& drift) {
  std::string moments;
  if (motion != nullptr) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), ", %zu moments in %.1f s", motion->seconds.size(),
                  static_cast<double>(motion->seconds.back()));
    moments = text.data();
  }
  std::printf("%s: %.2f MB, %zu targets%s\n", given.glb().c_str(), static_cast<double>(bytes) / 1e6,
              targets.all().size(), moments.c_str());
  std::printf(
      "farthest vertex from the face itself: median %.2f mm, nine of ten below %.2f mm, worst "
      "%.2f mm (%zu %s)\n",
      drift.median_mm, drift.most_mm, drift.worst_mm, drift.faces,
      motion != nullptr ? "moments" : "random faces");
}

/// The stream as an animation; what it looks at is measured too.
glb::Motion motion_of(const pipeline::AuMapping& mapping,
                      const std::vector<playback::TimedAus>& keyframes,
                      const glb::Sampling& sampling, const glb::MorphTargets& targets,
                      const glb::FaceRig& rig, glb::Drift& drift) {
  glb::Motion motion;
  const std::size_t count = glb::moment_count(keyframes, sampling);
  const std::size_t every = (count + kMeasuredMax - 1) / kMeasuredMax;
  glb::for_each_moment(
      mapping, keyframes, sampling, [&](double seconds, const pipeline::FaceState& state) {
        if (motion.seconds.size() % every == 0) drift.add(state);
        motion.seconds.push_back(static_cast<float>(seconds));
        const std::vector<std::uint8_t> weights = targets.weights(mapping.face, state);
        motion.weights.insert(motion.weights.end(), weights.begin(), weights.end());
        motion.joints.push_back(rig.pose(state.activations));
      });
  return motion;
}

Result<std::vector<playback::TimedAus>> keyframes_of(const PlayerOptions& options) {
  auto opened = open_stream(options.exported.stream(), {});
  if (!opened) return opened.error();
  if (!opened->found.empty()) spdlog::info("{}", opened->found);
  const std::size_t moments = glb::moment_count(opened->keyframes, sampling_of(options));
  if (moments > kMomentsMax) {
    return Error{ErrorKind::BadData,
                 at_place(options.exported.stream().string(),
                          std::to_string(moments) + " moments are more than the " +
                              std::to_string(kMomentsMax) +
                              " that are exported; give a lower --fps, or cut the stream")};
  }
  return std::move(opened->keyframes);
}

Result<sources::ArkitTable> read_curves(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  return sources::parse_arkit_table(*text, file.string());
}

}  // namespace

Result<void> run_export(const PlayerOptions& options) {
  const ExportOptions& given = options.exported;
  std::vector<playback::TimedAus> keyframes;
  glb::About about;
  if (!given.stream().empty()) {
    auto read = keyframes_of(options);
    if (!read) return read.error();
    keyframes = std::move(*read);
    if (const auto sound = sound::sound_beside(given.stream())) {
      about.sound = sound->filename().string();
    }
  }
  auto assets = load_assets(options.face);
  if (!assets) return assets.error();
  if (auto writable = check_writable(given.glb()); !writable) return writable;
  const face::Face& face = (*assets)->face;
  auto curves = read_curves((*assets)->data_folder / "sources" / "arkit_to_au.csv");
  if (!curves) return curves.error();
  about.curves = std::move(*curves);
  about.licence = licence_of(**assets);
  warn_of_missing(face, keyframes);

  const glb::FaceRig rig(face, given.basis == glb::Basis::Muscles);
  const glb::MorphTargets targets(face, given.basis, rig);
  glb::Drift drift(face, targets, rig);
  const pipeline::AuMapping mapping = au_mapping(**assets, options.face.mixer);
  std::optional<glb::Motion> motion;
  if (keyframes.empty()) {
    glb::add_random_faces(mapping, kRandomFaces, kRandomSeed, drift);
  } else {
    motion = motion_of(mapping, keyframes, sampling_of(options), targets, rig, drift);
    motion->name = given.stream().stem().string();
  }
  const glb::Motion* const moves = motion ? &*motion : nullptr;
  const auto bytes = glb::face_glb(face, targets, rig, moves, about);
  if (!bytes) return bytes.error();
  if (auto written = write_file_atomically(given.glb(), *bytes); !written) return written;
  if (!options.quiet) print_summary(given, bytes->size(), targets, moves, drift.summary());
  return {};
}

}  // namespace aucast::app
