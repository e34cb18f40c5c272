#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/gallery/gallery_plan.h"

namespace aucast::gallery {

/// The settings that all pictures of one gallery share.
struct GallerySetting {
  std::string face;
  std::string viewpoint;
  std::string background;  ///< RRGGBB, none or default
  std::string layers;      ///< in the form of --show
  std::string version;
  int width = 0;
  int height = 0;
};

/// sweep_strength() in percent, with one decimal.
[[nodiscard]] std::string strength_text(int time_ms);

/// A field of a CSV line as in RFC 4180: in quotes if it has a comma, a quote or a line end.
[[nodiscard]] std::string csv_field(std::string_view text);

/// The text of manifest.csv: a line of column names, then a line for each picture and for each
/// video of a sweep. `videos`: the sweeps whose videos were written, as indices into
/// GalleryPlan::sweeps. Lines end with CR LF. In fields with several values (aus, intensities in
/// percent, sides, expression, muscles) the values are separated by blanks and have the same order
/// in each field; fields that do not apply are empty. onset_ms to end_ms are the times at which the
/// phases of a sweep begin or end; strength is strength_text() of a frame.
[[nodiscard]] std::string format_manifest(const GalleryPlan& plan, const GallerySetting& setting,
                                          const std::vector<std::size_t>& videos);

}  // namespace aucast::gallery
