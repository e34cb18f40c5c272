#include "client/gui/editing/channel_groups.h"

#include <array>
#include <string>
#include <string_view>

#include "client/gui/editing/expression_editor.h"
#include "client/gui/texts/texts.h"
#include "common/text.h"

namespace aucast::gui {
namespace {

/// A word in a channel's name and the region that it stands for; the first that is found counts.
struct Clue {
  std::string_view word;
  TextKey region;
};

constexpr TextKey kBrow("region.brow");
constexpr TextKey kEyes("region.eyes");
constexpr TextKey kNose("region.nose");
constexpr TextKey kMouth("region.mouth");
constexpr TextKey kJaw("region.jaw");
constexpr TextKey kHead("region.head");
constexpr TextKey kOther("region.other");
constexpr std::array kRegions = {kBrow, kEyes, kNose, kMouth, kJaw, kHead, kOther};

constexpr std::array<Clue, 40> kClues = {{
    {"forehead", kBrow}, {"crows_feet", kEyes},  {"nose", kNose},       {"neck", kJaw},
    {"brow", kBrow},     {"head_", kHead},       {"lid", kEyes},        {"gaze", kEyes},
    {"oculi", kEyes},    {"cheek", kEyes},       {"frontalis", kBrow},  {"corrugat", kBrow},
    {"procerus", kBrow}, {"glabella", kBrow},    {"supercili", kBrow},  {"alaeque_nasi", kNose},
    {"nasalis", kNose},  {"nostril", kNose},     {"nasolabial", kNose}, {"nasi", kNose},
    {"jaw", kJaw},       {"mentalis", kJaw},     {"platysma", kJaw},    {"masseter", kJaw},
    {"chin", kJaw},      {"zygomatic", kMouth},  {"anguli", kMouth},    {"angular", kMouth},
    {"labi", kMouth},    {"oris", kMouth},       {"lip", kMouth},       {"corner", kMouth},
    {"risor", kMouth},   {"buccinator", kMouth}, {"incisiv", kMouth},   {"mouth", kMouth},
    {"tongue", kMouth},  {"dimple", kMouth},     {"smile", kMouth},     {"socket", kBrow},
}};

TextKey region_of(const std::string& name) {
  const std::string plain = lowered(name);
  for (const Clue& clue : kClues) {
    if (plain.find(clue.word) != std::string::npos) return clue.region;
  }
  return kOther;
}

std::string for_people(std::string name, bool paired) {
  if (paired) name.erase(0, name.find('_') + 1);
  std::replace(name.begin(), name.end(), '_', ' ');
  return data_word(name);
}

}  // namespace

std::vector<ChannelGroup> channel_groups(const face::Face& face,
                                         const std::vector<float>& activations) {
  std::vector<ChannelGroup> groups;
  for (const TextKey region : kRegions) {
    ChannelGroup group{tr(region), {}};
    for (std::size_t i = 0; i < face.channels.size(); ++i) {
      const face::Channel& channel = face.channels[i];
      if (region_of(channel.name).row() != region.row()) continue;
      const auto partner = partner_of(face, i);
      const bool is_left = !partner || split_side(channel.name).side == Side::Left;
      if (!is_left) continue;  // it stands on its partner's line
      ChannelRow row;
      row.name = for_people(channel.name, partner.has_value());
      row.maximum = channel.activation_max;
      row.left = static_cast<int>(i);
      row.left_value = activations[i];
      if (partner) {
        row.right = static_cast<int>(*partner);
        row.right_value = activations[*partner];
      }
      group.rows.push_back(std::move(row));
    }
    if (!group.rows.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace aucast::gui
