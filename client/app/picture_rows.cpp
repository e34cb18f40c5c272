#include "client/app/picture_rows.h"

#include <charconv>
#include <utility>

#include "client/app/read_number.h"
#include "client/view/video_encoder.h"
#include "common/text.h"

namespace aucast::app {
namespace {

using Kind = OptionValue::Kind;

constexpr int kSizeMax = view::kVideoSideMax;

Complaint read_size(const std::string& word, OutputOptions& output) {
  const auto parts = split(word, 'x');
  output.size_given = parts.size() == 2 && read_whole(parts[0], 1, kSizeMax, output.width) &&
                      read_whole(parts[1], 1, kSizeMax, output.height);
  if (output.size_given) return std::nullopt;
  return "is not WIDTHxHEIGHT, each 1 to " + std::to_string(kSizeMax) + ", such as 800x600";
}

Complaint read_background(const std::string& word, OutputOptions& output) {
  output.transparent = word == "none";
  output.background.reset();
  if (output.transparent) return std::nullopt;
  std::uint32_t rgb = 0;
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, rgb, 16);
  if (word.size() != 6 || read.ec != std::errc() || read.ptr != end) {
    return "is not RRGGBB, such as 808080, and not none";
  }
  output.background = rgb;
  return std::nullopt;
}

Complaint read_layers(const std::string& word, view::Layers& out) {
  auto layers = view::parse_layers(word);
  if (!layers) return "is not a list of layers: " + layers.error().message;
  out = *layers;
  return std::nullopt;
}

}  // namespace

std::vector<OptionRow> picture_rows(OutputOptions& output) {
  static const std::string kShown = "Layers, textured by default: " + view::layer_names() + ".";
  return {
      {.option = {"size", "WxH"},
       .text = "size of pictures and videos in pixels (800x600)",
       .more = "Size of the pictures in pixels, each side up to 8192: 800x600 by default, 300x375 "
               "in a gallery.",
       .value = parsed(Kind::Word, read_size, output),
       .heading = "Pictures"},
      {.option = {"background", "RRGGBB"},
       .text = "colour behind the face, or none: transparent PNGs",
       .more = "A plain background of this colour behind the face. The word none in place of a "
               "colour makes PNGs transparent there.",
       .value = parsed(Kind::Word, read_background, output)},
      {.option = {"show", "LAYER[,...]"},
       .text = "what is drawn: layers, see below (textured)",
       .more = kShown,
       .value = parsed(Kind::Word, read_layers, output.layers)},
  };
}

OptionRow viewpoint_row(PoseOptions& pose) {
  std::vector<std::pair<std::string_view, view::ViewpointPreset>> names;
  for (const auto preset : {view::ViewpointPreset::Front, view::ViewpointPreset::ThreeQuarter,
                            view::ViewpointPreset::Profile}) {
    names.emplace_back(name(preset), preset);
  }
  return {.option = {"camera", "VIEW", "front"},
          .text = "front, three-quarter or profile (front)",
          .value = one_of(pose.viewpoint, std::move(names))};
}

}  // namespace aucast::app
