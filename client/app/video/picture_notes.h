#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/face/face.h"
#include "client/face/muscle_mixer.h"
#include "client/view/png_text.h"
#include "client/view/style.h"
#include "common/action_unit.h"

namespace aucast::app {

/// What a picture shows and how it was made.
struct PictureNotes {
  const face::Face& face;
  std::optional<AuFrame> aus;  ///< as the face shows them, after the rules; nullopt: the face is
                               ///< made of muscles alone
  std::string_view rules{};
  face::Mixer mixer = face::Mixer::Maximum;
  view::Layers layers = {};
  std::string_view viewpoint{};  ///< of --camera; empty: turned by hand
  std::span<const float> activations{};
  std::string_view edited{};  ///< what was edited, if there are no AUs; empty: nothing
};

/// The notes as texts of a PNG, so that the picture explains itself and can be made again. Their
/// keywords are Software, Face, AUs (as in a packet) or Edited, Rules, Mixer, Camera, Layers, and
/// Activations (as for `pose --muscle`). Entries without a value are left out.
[[nodiscard]] std::vector<view::PngText> texts_of(const PictureNotes& notes);

}  // namespace aucast::app
