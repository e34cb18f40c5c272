#include "common/camera/face_models.h"

#include <span>
#include <system_error>
#include <utility>

#include "common/files.h"
#include "common/text.h"

namespace aucast::camera {
namespace {

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The command that fetches the models.
std::string fetching(const std::filesystem::path& data) {
  // An installation has the script in its data folder.
  const std::filesystem::path script = std::filesystem::path("scripts") / "install_models.sh";
  const auto installed = data / script;
  std::error_code ignored;
  const bool there = std::filesystem::exists(installed, ignored);
  return printable((there ? installed : script).string()) + " " + printable(data.string());
}

/// A model file, or the sentence that says where to get it.
Result<std::string> read_model_file(const std::filesystem::path& data,
                                    const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) return read_file(file);
  return Error{ErrorKind::Unreadable,
               at_place(file.string(), "the models that read faces are not installed; '" +
                                           fetching(data) + "' fetches them")};
}

}  // namespace

Result<FaceModels> load_face_models() {
  const auto data = find_data_folder({});
  if (!data) return data.error();
  return load_face_models(*data);
}

Result<FaceModels> load_face_models(const std::filesystem::path& data) {
  const auto detector_file = data / "models" / "face_detection_short_range.tflite";
  const auto landmark_file = data / "models" / "face_landmark_with_attention.tflite";
  const auto weights_file = data / "camera" / "action_units.txt";
  const auto detector = read_model_file(data, detector_file);
  if (!detector) return detector.error();
  const auto landmarks = read_model_file(data, landmark_file);
  if (!landmarks) return landmarks.error();
  const auto text = read_file(weights_file);
  if (!text) return text.error();
  auto weights = mesh::parse_au_weights(*text, weights_file.string());
  if (!weights) return weights.error();
  auto tracker = mesh::FaceTracker::make({bytes_of(*detector), detector_file.string()},
                                         {bytes_of(*landmarks), landmark_file.string()});
  if (!tracker) {
    const Error& error = tracker.error();
    return Error{error.kind, error.message + "; '" + fetching(data) + "' fetches it anew"};
  }
  return FaceModels{std::move(*tracker), std::move(*weights)};
}

}  // namespace aucast::camera
