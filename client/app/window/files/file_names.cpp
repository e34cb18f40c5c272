#include "client/app/window/files/file_names.h"

#include <system_error>

#include "client/gallery/gallery_plan.h"
#include "common/text.h"

namespace aucast::app {
namespace {

namespace fs = std::filesystem;

gui::PictureWords words_of(const Named& shown, const std::string& date) {
  gui::PictureWords words;
  words.face = shown.face;
  words.date = date;
  words.stream = shown.stream;
  if (shown.keyframe > 0) words.keyframe = std::to_string(shown.keyframe);
  words.aus = shown.aus ? gallery::file_stem(*shown.aus) : shown.edited;
  return words;
}

}  // namespace

std::string new_file_name(gui::Purpose purpose, const Named& shown) {
  const std::string& stream = shown.stream;
  const std::string& face = stream.empty() ? shown.face : stream;
  const std::string ending(gui::ending_of(purpose));
  switch (purpose) {
    case gui::Purpose::ExportKeyframes:
      // Beside the stream itself, which has the same ending.
      return (stream.empty() ? "played" : stream + "_played") + ending;
    case gui::Purpose::ExportTable:
      return (stream.empty() ? "played" : stream) + ending;
    case gui::Purpose::ExportMesh:
    case gui::Purpose::ExportGlb:
      return face + ending;
    case gui::Purpose::LogOnsets:
      return (stream.empty() ? "onsets" : stream + "_onsets") + ending;
    case gui::Purpose::ExportAu:
      return "au" + std::to_string(shown.au) + ending;
    case gui::Purpose::SaveStream: {
      const std::string composed = shown.composition.filename().string();
      return composed.empty() ? kComposedName : composed;
    }
    case gui::Purpose::PlayStream:
    case gui::Purpose::ComposeStream:
    case gui::Purpose::ImportAus:
    case gui::Purpose::PictureFolder:
    case gui::Purpose::GalleryFolder:
    case gui::Purpose::LookForFaces:
    case gui::Purpose::CameraFilm:
    case gui::Purpose::AuthoritiesFile:
    case gui::Purpose::TokenFile:
      break;  // these open what is there
  }
  return {};
}

Result<fs::path> new_picture_file(const gui::PictureSettings& settings, const Named& shown,
                                  const std::string& date, const std::string& ending) {
  const fs::path folder = settings.folder.empty() ? fs::path(".") : fs::path(settings.folder);
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) {
    return Error{ErrorKind::Failed, "cannot make " + at_place(folder.string(), failed.message())};
  }
  const gui::PictureWords words = words_of(shown, date);
  const auto first = gui::picture_name(settings.pattern, words, 1);
  if (!first) return first.error();
  const bool counts = settings.pattern.find("{number}") != std::string::npos;
  for (int number = 1;; ++number) {
    std::string name = *first;
    if (counts) {
      name = *gui::picture_name(settings.pattern, words, number);
    } else if (number > 1) {
      name += "-" + std::to_string(number);
    }
    fs::path file = folder / (name + ending);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return file;
  }
}

}  // namespace aucast::app
