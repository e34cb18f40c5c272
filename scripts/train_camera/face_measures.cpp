#include <charconv>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "common/files.h"
#include "common/mesh/face_tracker.h"
#include "common/mesh/measures.h"
#include "common/number_of.h"

/// Pictures in, what a camera source measures on them out: for the training of its weights and for
/// looking at it.
namespace aucast {
namespace {

int fail(const Error& error) {
  std::fprintf(stderr, "face-measures: %s\n", error.message.c_str());
  return exit_code(error);
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void print_header() {
  std::printf("picture,presence,turn-left,turn-up,tilt-left,scale");
  for (const char* side : {"left-", "right-"}) {
    for (const auto name : mesh::side_measure_names()) {
      std::printf(",%s%.*s", side, static_cast<int>(name.size()), name.data());
    }
  }
  for (const auto name : mesh::middle_measure_names()) {
    std::printf(",%.*s", static_cast<int>(name.size()), name.data());
  }
  for (const char axis : {'x', 'y', 'z'}) {
    for (const std::size_t point : mesh::kStillLandmarks) std::printf(",%c%zu", axis, point);
  }
  std::printf("\n");
}

void print_row(std::size_t picture, const mesh::Landmarks& landmarks,
               const mesh::StillPoints& onto) {
  const mesh::FittedHead head = mesh::fit_head(landmarks, onto);
  const mesh::Measures measures = mesh::measure(head);
  std::printf("%zu,%.4f,%.5f,%.5f,%.5f,%.4f", picture, landmarks.presence, measures.turn.left_rad,
              measures.turn.up_rad, measures.turn.tilt_left_rad, measures.scale);
  for (const auto* side : {&measures.left, &measures.right}) {
    for (const double number : *side) std::printf(",%.6f", number);
  }
  for (const double number : measures.middle) std::printf(",%.6f", number);
  for (const double mesh::Point::*axis : {&mesh::Point::x, &mesh::Point::y, &mesh::Point::z}) {
    for (const std::size_t point : mesh::kStillLandmarks) {
      std::printf(",%.4f", landmarks.points[point].*axis);
    }
  }
  std::printf("\n");
}

int run(const std::vector<std::string>& arguments) {
  const auto width = arguments.size() == 3 ? number_of<std::size_t>(arguments[1]) : std::nullopt;
  const auto height = arguments.size() == 3 ? number_of<std::size_t>(arguments[2]) : std::nullopt;
  if (width.value_or(0) == 0 || height.value_or(0) == 0) {
    std::fprintf(stderr, "usage: face-measures MODELS WIDTH HEIGHT < rgb24 > measures.csv\n");
    return exit_code({ErrorKind::Usage, {}});
  }
  const auto detector = read_file(arguments[0] + "/face_detection_short_range.tflite");
  if (!detector) return fail(detector.error());
  const auto landmarks = read_file(arguments[0] + "/face_landmark_with_attention.tflite");
  if (!landmarks) return fail(landmarks.error());
  auto tracker =
      mesh::FaceTracker::make({bytes_of(*detector), "face_detection_short_range.tflite"},
                              {bytes_of(*landmarks), "face_landmark_with_attention.tflite"});
  if (!tracker) return fail(tracker.error());
  std::vector<std::uint8_t> rgb(*width * *height * 3);
  print_header();
  for (std::size_t picture = 0; std::fread(rgb.data(), 1, rgb.size(), stdin) == rgb.size();
       ++picture) {
    if (const auto face = tracker->follow({*width, *height, rgb})) {
      print_row(picture, *face, mesh::kTypicalStillPoints);
    }
  }
  return 0;
}

}  // namespace
}  // namespace aucast

int main(int argument_count, char** arguments) {
  return aucast::run({arguments + 1, arguments + argument_count});
}
