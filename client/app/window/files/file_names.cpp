#include "client/app/window/files/file_names.h"

#include <array>
#include <ctime>

#include "client/gallery/gallery_plan.h"

namespace aucast::app {
namespace {

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::localtime_r(&now, &parts);
  std::array<char, 16> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
  return {text.data(), length};
}

}  // namespace

std::string new_file_name(gui::Purpose purpose, const Named& shown) {
  const std::string& stream = shown.stream;
  const std::string& face = stream.empty() ? shown.face : stream;
  switch (purpose) {
    case gui::Purpose::ExportKeyframes:
      // Beside the stream itself, which is a .txt too.
      return stream.empty() ? "played.txt" : stream + "_played.txt";
    case gui::Purpose::ExportTable:
      return stream.empty() ? "played.csv" : stream + ".csv";
    case gui::Purpose::ExportMesh:
      return face + ".obj";
    case gui::Purpose::ExportGlb:
      return face + ".glb";
    case gui::Purpose::LogOnsets:
      return stream.empty() ? "onsets.csv" : stream + "_onsets.csv";
    case gui::Purpose::ExportAu:
      return "au" + std::to_string(shown.au) + ".toml";
    default: {
      const std::string composed = shown.composition.filename().string();
      return composed.empty() ? kComposedName : composed;
    }
  }
}

Result<std::filesystem::path> new_picture_file(const gui::PictureSettings& settings,
                                               const Named& shown, const std::string& ending) {
  gui::PictureWords words;
  words.face = shown.face;
  words.date = today();
  words.stream = shown.stream;
  if (shown.keyframe > 0) words.keyframe = std::to_string(shown.keyframe);
  words.aus = shown.aus ? gallery::file_stem(*shown.aus) : shown.edited;
  return gui::picture_file(settings, words, ending);
}

}  // namespace aucast::app
