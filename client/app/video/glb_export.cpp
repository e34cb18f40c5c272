#include "client/app/video/glb_export.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "client/app/missing_aus.h"
#include "client/glb/drift.h"
#include "client/glb/face_glb.h"
#include "client/glb/motion.h"
#include "common/files.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/limits.h"

namespace aucast::app {
namespace {

constexpr int kFps = 30;
/// The most samples: nine hours at 30 a second, with 110 MB of weights.
constexpr std::size_t kSamplesMax = 1'000'000;
/// For how many samples (without a stream, random faces) the error is measured.
constexpr std::size_t kMeasuredMax = 2000;
constexpr std::size_t kRandomFaces = 200;
constexpr std::uint64_t kRandomSeed = 1;

glb::Sampling sampling_of(const PlayerOptions& options) {
  return {.fps = options.output.fps.value_or(kFps),
          .untimed = options.playback.speed.value_or(protocol::kDefaultKeyframeTime),
          .interpolation = options.playback.interpolation,
          .idle = {options.playback.idle_seed, options.playback.blink}};
}

/// Logs once what the stream asks for and the face cannot show.
void warn_of_missing(const face::Face& face, const playback::KeyframeList& keyframes) {
  AuFrame all;
  for (const playback::Keyframe& keyframe : keyframes) all = stronger(all, keyframe.aus);
  if (const std::string missing = missing_text(face, all); !missing.empty()) {
    spdlog::warn("{}", missing);
  }
}

/// The licence of a face. Faces in data/ have the project's own, however their folder is written.
std::string licence_of(const Assets& assets) {
  std::error_code ignored;
  const bool shipped =
      std::filesystem::equivalent(assets.face_folder / "..", assets.data_folder / "faces", ignored);
  return shipped ? "MIT licence, AUcast" : "";
}

std::string glb_summary(const ExportOptions& given, std::size_t bytes,
                        const glb::MorphTargets& targets, const glb::Motion* motion,
                        const glb::Drift::Summary& drift) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), ": %.2f MB, %zu targets",
                static_cast<double>(bytes) / 1e6, targets.all().size());
  std::string lines = given.glb().string() + text.data();
  if (motion != nullptr) {
    std::snprintf(text.data(), text.size(), ", %zu samples in %.1f s", motion->seconds.size(),
                  static_cast<double>(motion->seconds.back()));
    lines += text.data();
  }
  std::snprintf(
      text.data(), text.size(),
      "\nfarthest vertex from the face itself: median %.2f mm, nine of ten below %.2f mm, "
      "worst %.2f mm (%zu %s)",
      drift.median_mm, drift.most_mm, drift.worst_mm, drift.faces,
      motion != nullptr ? "samples" : "random faces");
  return lines + text.data();
}

/// The stream as an animation, whose samples are added to the drift; nullopt if it was stopped.
std::optional<glb::Motion> motion_of(const pipeline::AuMapping& mapping,
                                     const playback::KeyframeList& keyframes,
                                     const glb::Sampling& sampling,
                                     const glb::MorphTargets& targets, const glb::FaceRig& rig,
                                     glb::Drift& drift, const OnSample& on_sample) {
  std::optional<glb::Motion> motion(std::in_place);
  const std::size_t count = glb::sample_count(keyframes, sampling);
  const std::size_t every = (count + kMeasuredMax - 1) / kMeasuredMax;
  glb::for_each_sample(
      mapping, keyframes, sampling, [&](double seconds, const pipeline::FaceState& state) {
        if (on_sample && !on_sample(motion->seconds.size(), count)) {
          motion.reset();
          return false;
        }
        if (motion->seconds.size() % every == 0) drift.add(state);
        motion->seconds.push_back(static_cast<float>(seconds));
        const std::vector<std::uint8_t> weights = targets.weights(mapping.face, state);
        motion->weights.insert(motion->weights.end(), weights.begin(), weights.end());
        motion->joints.push_back(rig.pose(state.activations));
        return true;
      });
  return motion;
}

Result<sources::ArkitTable> read_curves(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  return sources::parse_arkit_table(*text, file.string());
}

}  // namespace

Result<void> check_length(const playback::KeyframeList& keyframes, const PlayerOptions& options,
                          const std::string& place) {
  const std::size_t samples = glb::sample_count(keyframes, sampling_of(options));
  if (samples <= kSamplesMax) return {};
  return Error{ErrorKind::BadData,
               at_place(place, std::to_string(samples) + " samples are more than the " +
                                   std::to_string(kSamplesMax) +
                                   " that are exported; give a lower --fps, or cut the stream")};
}

Result<std::string> export_glb(const Assets& assets, const PlayerOptions& options,
                               const ExportedStream& stream, const OnSample& on_sample) {
  const ExportOptions& given = options.exported;
  if (auto writable = check_writable(given.glb()); !writable) return writable.error();
  const face::Face& face = assets.face;
  auto curves = read_curves(assets.data_folder / "sources" / "arkit_to_au.csv");
  if (!curves) return curves.error();
  glb::About about;
  about.sound = stream.sound;
  about.curves = std::move(*curves);
  about.licence = licence_of(assets);
  warn_of_missing(face, stream.keyframes);

  const glb::FaceRig rig(face, given.basis == glb::Basis::Muscles);
  const glb::MorphTargets targets(face, given.basis, rig);
  glb::Drift drift(face, targets, rig);
  const pipeline::AuMapping mapping = au_mapping(assets, options.face.mixer);
  std::optional<glb::Motion> motion;
  if (stream.keyframes.empty()) {
    glb::add_random_faces(mapping, kRandomFaces, kRandomSeed, drift);
  } else {
    motion =
        motion_of(mapping, stream.keyframes, sampling_of(options), targets, rig, drift, on_sample);
    if (!motion) return Error{ErrorKind::Failed, "stopped; no GLB file was written"};
    motion->name = stream.name;
  }
  const glb::Motion* const moves = motion ? &*motion : nullptr;
  const auto bytes = glb::face_glb(face, targets, rig, moves, about);
  if (!bytes) return bytes.error();
  if (auto written = write_file_atomically(given.glb(), *bytes); !written) return written.error();
  return glb_summary(given, bytes->size(), targets, moves, drift.summary());
}

}  // namespace aucast::app
