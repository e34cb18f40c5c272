#include "client/gui/model/gallery_view.h"

#include <algorithm>
#include <sstream>

#include "client/gui/model/picture_settings.h"

namespace aucast::gui {

std::vector<std::string> wanted_sections(const GallerySettings& settings) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kGallerySections.size(); ++i) {
    if (settings.sections[i]) names.emplace_back(kGallerySections[i].name);
  }
  return names;
}

std::vector<std::string> wanted_sweeps(const GallerySettings& settings) {
  if (!settings.sections.back()) return {};
  std::istringstream words(settings.sweeps);
  std::vector<std::string> sweeps;
  for (std::string word; words >> word;) sweeps.push_back(word);
  return sweeps;
}

std::string progress_text(const GalleryView& view) {
  constexpr long kMinute = 60;
  if (view.ending) return tr("gallery.ending");
  if (view.total == 0) return tr("gallery.beginning");
  const std::string drawn = tr("gallery.progress", view.drawn, view.total);
  if (!view.left_s) return drawn;
  const long left = *view.left_s;
  return drawn + ", " +
         (left < 2 * kMinute ? tr("gallery.seconds_left", left)
                             : tr("gallery.minutes_left", (left + kMinute / 2) / kMinute));
}

std::string problem(const GallerySettings& settings) {
  if (settings.folder.empty()) return tr("gallery.no_folder");
  if (wanted_sections(settings).empty()) return tr("gallery.no_section");
  for (const int side : {settings.width, settings.height}) {
    if (side < kPictureSideMin || side > kPictureSideMax) {
      return tr("gallery.wrong_size", kPictureSideMin, kPictureSideMax);
    }
  }
  if (settings.sections.back() && wanted_sweeps(settings).empty()) {
    return tr("gallery.no_sweep");
  }
  return {};
}

}  // namespace aucast::gui
