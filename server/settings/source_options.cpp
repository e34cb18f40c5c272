#include "server/settings/source_options.h"

#include <utility>

#include "common/sources/resample.h"
#include "common/text.h"

namespace aucast::server {
namespace {

using Kind = OptionValue::Kind;

/// No camera is faster.
constexpr double kFpsMax = 1000;

/// A stream with less than one keyframe in ten seconds is no face.
constexpr double kRateMin = 0.1;

Complaint read_fps(const std::string& word, std::optional<double>& out) {
  const auto fps = number_of<double>(word);
  if (!fps || !(*fps > 0 && *fps <= kFpsMax)) {
    return "is not a number of pictures a second above 0, at most 1000";
  }
  out = fps;
  return std::nullopt;
}

Complaint read_au_scale(const std::string& word, std::optional<double>& out) {
  out.reset();
  if (word == "auto") return std::nullopt;
  const double scale = number_of<double>(word).value_or(0);
  if (scale != 1 && scale != 5 && scale != 100) return "is not one of 1, 5, 100 and auto";
  out = scale;
  return std::nullopt;
}

Complaint read_face_id(const std::string& word, sources::RecordingOptions& recording) {
  recording.all_faces = word == "all";
  recording.face = number_of<std::int64_t>(word);
  if (recording.face || recording.all_faces) return std::nullopt;
  return "is neither a whole number nor all";
}

Complaint read_size(const std::string& word, camera::CameraOptions& camera) {
  const auto sides = split(word, 'x');
  const auto width = number_of<int>(sides[0]);
  const auto height = sides.size() == 2 ? number_of<int>(sides[1]) : std::nullopt;
  const auto possible = [](std::optional<int> side) {
    return side && *side >= 16 && *side <= 8192;
  };
  if (!possible(width) || !possible(height)) return "is not WIDTHxHEIGHT, such as 1280x720";
  camera.width = *width;
  camera.height = *height;
  return std::nullopt;
}

}  // namespace

std::string options_of_recordings(const SourceOptions& options) {
  const SourceOptions untouched;
  const SignalOptions& signal = options.signal;
  const std::pair<bool, const char*> given[] = {
      {options.recording.fps.has_value(), "--fps"},
      {options.recording.au_scale.has_value(), "--au-scale"},
      {options.recording.confidence_min != untouched.recording.confidence_min, "--min-confidence"},
      {options.recording.face || options.recording.all_faces, "--face-id"},
      {signal.distance, "--distance"},
      {signal.neutral_auto || signal.neutral_seconds, "--neutral"},
      {!signal.gain.empty(), "--gain"},
      {signal.filter.has_value(), "--filter"},
      {!signal.dead_band.empty(), "--dead-band"},
      {!signal.profile.empty(), "--profile"}};
  std::string names;
  for (const auto& [is_given, name] : given) {
    if (is_given) names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

std::vector<OptionRow> camera_rows(camera::CameraOptions& options) {
  return {
      {.option = {"camera-size", "WxH", "640x480"},
       .text = "size to ask a camera for (640x480)",
       .more = "The size that a camera is asked for. Larger pictures are reduced to at most "
               "640x640 pixels before faces are read in them.",
       .value = parsed(Kind::Word, read_size, options)},
      {.option = {"camera-fps", "N", "30"},
       .text = "pictures a second to ask a camera for (30)",
       .more = "The pictures a second that a camera is asked for, 1 to 120. A picture that comes "
               "while the one before is still being read is dropped.",
       .value = whole(options.fps, 1, 120)},
  };
}

std::vector<OptionRow> recording_rows(SourceOptions& options) {
  sources::RecordingOptions& recording = options.recording;
  return {
      {.option = {"rate", "HZ"},
       .text = "resample to HZ keyframes a second",
       .more = "Resamples to this rate, 0.1 to 1000, by linear interpolation.",
       .value = real(options.rate, kRateMin, sources::kRateMax,
                     "is not a number of keyframes a second from 0.1 to 1000"),
       .heading = "Recordings, cameras"},
      {.option = {"fps", "N"},
       .text = "frame rate of recordings without times",
       .more = "Pictures a second, for recordings without times (Py-Feat) or with wrong ones.",
       .value = parsed(Kind::Number, read_fps, recording.fps)},
      {.option = {"au-scale", "S", "auto"},
       .text = "value of full intensity: 1, 5, 100 or auto (auto)",
       .more = "The number that stands for full intensity in recordings: 1, 5, 100 or auto.",
       .value = parsed(Kind::Number, read_au_scale, recording.au_scale)},
      {.option = {"min-confidence", "C", "0.5"},
       .text = "skip rows with less confidence, 0 to 1 (0.5)",
       .more = "Rows with a lower confidence, 0 to 1, count as no data. While there is no data, "
               "the face holds for 0.5 s, then returns to neutral within 1 s.",
       .value = real(recording.confidence_min, 0, 1, "is not a number from 0 to 1")},
      {.option = {"face-id", "N"},
       .text = "which of several faces, or all",
       .more =
           "Which of several faces. Without it: the most frequent one of a recording, the first "
           "one of a live source, the clearest one of a film or camera. Faces of films and cameras "
           "are counted from 0 as they are first seen. With all, each face is a stream of its own, "
           "STEM-FACE such as webcam-0. A recording gives at most 64, the most frequent first. A "
           "live source gives at most 16, each from when it is first seen; before them comes a "
           "stream without a number, which exists from the start and follows one of the faces.",
       .value = parsed(Kind::Number, read_face_id, recording)},
  };
}

}  // namespace aucast::server
