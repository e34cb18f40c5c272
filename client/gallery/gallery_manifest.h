#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/gallery/gallery_plan.h"

namespace aucast::gallery {

/// What is the same for all pictures of one gallery.
struct GallerySetting {
  std::string face;
  std::string viewpoint;
  std::string background;  ///< RRGGBB, none or default
  std::string layers;      ///< as --show takes them
  std::string version;
  int width = 0;
  int height = 0;
};

/// A field of a CSV line after RFC 4180: in quotes when it holds a comma, a quote or a line's end.
[[nodiscard]] std::string csv_field(std::string_view text);

/// manifest.csv: a line of names, then a line for each picture and for each sweep's video that was
/// written (`videos`: indexes into GalleryPlan::sweeps). Lines end with CR LF. Fields with several
/// values (aus, intensities in percent, sides, expression, muscles) have blanks between them, in
/// the same order; what does not apply is empty. The times say where each phase of a sweep
/// begins, strength what percentage of the intensities a frame of it has.
[[nodiscard]] std::string format_manifest(const GalleryPlan& plan, const GallerySetting& setting,
                                          const std::vector<std::size_t>& videos);

}  // namespace aucast::gallery
