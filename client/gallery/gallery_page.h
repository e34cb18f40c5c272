#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/gallery/gallery_manifest.h"
#include "client/gallery/gallery_plan.h"

namespace aucast::gallery {

/// Text made safe inside HTML, also between quotes.
[[nodiscard]] std::string html_escaped(std::string_view text);

/// index.html: one page with its style inside, pictures by relative links. `videos` as in
/// format_manifest.
[[nodiscard]] std::string format_page(const GalleryPlan& plan, const GallerySetting& setting,
                                      const std::vector<std::size_t>& videos);

}  // namespace aucast::gallery
