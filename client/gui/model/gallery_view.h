#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "client/gallery/section_names.h"
#include "client/gui/texts/texts.h"

namespace aucast::gui {

/// A section of a gallery: its name in `gallery --only`, its text and its tip.
struct GallerySection {
  std::string_view name;
  TextKey text;
  TextKey tip;
};
inline constexpr std::array<GallerySection, gallery::kSectionNames.size()> kGallerySections = {{
    {gallery::kAusSection, "gallery.aus", "gallery.aus_tip"},
    {gallery::kPrototypesSection, "gallery.prototypes", "gallery.prototypes_tip"},
    {gallery::kCombinationsSection, "gallery.combinations", "gallery.combinations_tip"},
    {gallery::kAppendixASection, "gallery.appendix_a", "gallery.appendix_a_tip"},
    {gallery::kAppendixBSection, "gallery.appendix_b", "gallery.appendix_b_tip"},
    {gallery::kCoverageSection, "gallery.coverage", "gallery.coverage_tip"},
    {gallery::kSweepsSection, "gallery.sweeps", "gallery.sweeps_tip"},
}};

/// What a gallery is made of.
struct GallerySettings {
  std::string folder;
  std::array<bool, kGallerySections.size()> sections{true, true, false, false, false, false, false};
  std::string sweeps = "12";  ///< AUs and names of expressions, separated by blanks
  int width = 600;            ///< width of a picture, pixels, 16-4096
  int height = 750;
  friend bool operator==(const GallerySettings&, const GallerySettings&) = default;
};

struct GalleryView {
  bool open = false;  ///< the dialog
  GallerySettings settings;
  std::size_t planned = 0;  ///< how many pictures would be made
  std::string complaint;    ///< why no pictures can be made, as a sentence; empty: they can
  bool running = false;
  bool ending = false;  ///< the making was cancelled but has not ended yet
  std::size_t drawn = 0;
  std::size_t total = 0;         ///< 0: unknown so far
  std::optional<long> left_s{};  ///< about how many seconds the rest will take; nullopt: unknown so
                                 ///< far
  std::string outcome;  ///< how the last gallery ended, as a sentence; empty: there was none
  bool failed = false;
  bool stopped = false;  ///< the user stopped it before it was complete
  friend bool operator==(const GalleryView&, const GalleryView&) = default;
};

// The dialog's commands.

struct OpenGallery {};
/// Closes the dialog. Pictures go on being made.
struct CloseGallery {};
struct ChangeGallery {
  GallerySettings settings;
};
struct BeginGallery {};
struct CancelGallery {};
using GalleryCommand =
    std::variant<OpenGallery, CloseGallery, ChangeGallery, BeginGallery, CancelGallery>;

/// The names of the sections that are wanted.
[[nodiscard]] std::vector<std::string> wanted_sections(const GallerySettings& settings);
/// The sweeps that are wanted; empty if the section of sweeps is not wanted.
[[nodiscard]] std::vector<std::string> wanted_sweeps(const GallerySettings& settings);
/// "3 of 10 pictures, about 2 min left": how far the making of a gallery is.
[[nodiscard]] std::string progress_text(const GalleryView& view);
/// Why no gallery can be made with these settings, as a sentence; empty: a gallery can be made.
[[nodiscard]] std::string problem(const GallerySettings& settings);

}  // namespace aucast::gui
