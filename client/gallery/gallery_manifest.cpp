#include "client/gallery/gallery_manifest.h"

#include <array>
#include <cstdio>

#include "client/face/side_word.h"
#include "protocol/codec.h"

namespace aucast::gallery {
namespace {

constexpr std::string_view kNames =
    "file,aus,intensities,sides,aus_after_rules,expression,muscles,face,mixer,rules,camera,width,"
    "height,background,show,version,frame,time_ms,strength,onset_ms,apex_ms,offset_ms,end_ms\r\n";

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += ' ';
    text += word;
  }
  return text;
}

std::string muscles_text(const std::vector<ExpressionMuscle>& muscles) {
  std::vector<std::string> words;
  for (const ExpressionMuscle& muscle : muscles) {
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "%s=%g/%g", muscle.name.c_str(),
                  static_cast<double>(muscle.left), static_cast<double>(muscle.right));
    words.emplace_back(text.data());
  }
  return joined(words);
}

/// The fields from aus to rules. A face made of muscles alone has neither rules nor mixer.
std::vector<std::string> what_is_shown(const GalleryPicture& picture, const std::string& face) {
  const bool only_muscles = !picture.muscles.empty() && picture.aus == AuFrame{};
  std::vector<std::string> numbers;
  std::vector<std::string> intensities;
  std::vector<std::string> sides;
  for (const AuTerm& term : canonical_terms(picture.aus)) {
    if (only_muscles) break;
    numbers.push_back(std::to_string(term.number));
    intensities.push_back(std::to_string(term.percent));
    sides.emplace_back(face::side_word(term.side));
  }
  return {joined(numbers),
          joined(intensities),
          joined(sides),
          only_muscles ? "" : protocol::format_au_set(picture.shown),
          joined(picture.sources),
          muscles_text(picture.muscles),
          face,
          only_muscles ? "" : std::string(face::name(picture.mixer)),
          only_muscles ? "" : picture.rules};
}

std::string line(const std::string& file, const GalleryPicture& picture,
                 const GallerySetting& setting, bool video) {
  std::vector<std::string> fields{file};
  const auto shown = what_is_shown(picture, setting.face);
  fields.insert(fields.end(), shown.begin(), shown.end());
  fields.insert(fields.end(),
                {setting.viewpoint, std::to_string(setting.width), std::to_string(setting.height),
                 setting.background, setting.layers, setting.version});
  if (picture.sweep_frame) {
    const bool still = !video;
    fields.push_back(still ? std::to_string(picture.sweep_frame->number) : "");
    fields.push_back(still ? std::to_string(picture.sweep_frame->time_ms) : "");
    fields.push_back(still ? strength_text(picture.sweep_frame->time_ms) : "");
    for (const int ms : {kOnsetMs, kApexMs, kOffsetMs, kSweepEndMs}) {
      fields.push_back(std::to_string(ms));
    }
  } else {
    fields.resize(fields.size() + 7);
  }
  std::string text;
  for (const std::string& field : fields) {
    if (!text.empty()) text += ',';
    text += csv_field(field);
  }
  return text + "\r\n";
}

}  // namespace

std::string strength_text(int time_ms) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.1f",
                100 * static_cast<double>(sweep_strength(time_ms)));
  return text.data();
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string format_manifest(const GalleryPlan& plan, const GallerySetting& setting,
                            const std::vector<std::size_t>& videos) {
  std::string text(kNames);
  for (const GalleryPicture& picture : plan.pictures) {
    text += line(picture.file, picture, setting, false);
  }
  for (const std::size_t index : videos) {
    const GallerySweep& sweep = plan.sweeps[index];
    text += line("sweeps/" + sweep.name + ".mp4", plan.pictures[sweep.begin], setting, true);
  }
  return text;
}

}  // namespace aucast::gallery
