#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/gallery/gallery_manifest.h"
#include "client/gallery/gallery_plan.h"

namespace aucast::gallery {

/// The text escaped for HTML, also for attributes in quotes.
[[nodiscard]] std::string html_escaped(std::string_view text);

/// The text of index.html: one page that contains its style and has relative links to the pictures.
/// `videos` as in format_manifest().
[[nodiscard]] std::string format_page(const GalleryPlan& plan, const GallerySetting& setting,
                                      const std::vector<std::size_t>& videos);

}  // namespace aucast::gallery
