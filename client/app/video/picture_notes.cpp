#include "client/app/video/picture_notes.h"

#include <array>
#include <charconv>
#include <utility>

#include "protocol/codec.h"

namespace aucast::app {
namespace {

/// The shortest text that reads back as the same activation.
std::string text_of(float activation) {
  std::array<char, 24> digits{};
  return {digits.data(),
          std::to_chars(digits.data(), digits.data() + digits.size(), activation).ptr};
}

std::string activations_text(const face::Face& face, std::span<const float> activations) {
  std::string text;
  for (std::size_t i = 0; i < activations.size(); ++i) {
    if (activations[i] == 0.0F) continue;
    if (!text.empty()) text += ' ';
    text += face.channels[i].name + '=' + text_of(activations[i]);
  }
  return text;
}

}  // namespace

std::vector<view::PngText> texts_of(const PictureNotes& notes) {
  std::vector<view::PngText> texts;
  const auto add = [&](const char* keyword, std::string text) {
    if (!text.empty()) texts.push_back({keyword, std::move(text)});
  };
  add("Software", "face-player " AUCAST_VERSION " (AUcast)");
  add("Face", notes.face.name);
  if (notes.aus) {
    add("AUs", protocol::format_au_set(*notes.aus));
    add("Rules", std::string(notes.rules));
    add("Mixer", std::string(face::name(notes.mixer)));
  }
  add("Edited", std::string(notes.edited));
  if (!notes.edited.empty()) {
    add("Rules", std::string(notes.rules));
    add("Mixer", std::string(face::name(notes.mixer)));
  }
  add("Camera", std::string(notes.viewpoint));
  add("Layers", view::format_layers(notes.layers));
  add("Activations", activations_text(notes.face, notes.activations));
  return texts;
}

}  // namespace aucast::app
