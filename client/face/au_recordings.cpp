#include "client/face/au_recordings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/text.h"

namespace aucast::face {
namespace {

/// One `name = value` of a drive table that found its channels.
struct Drive {
  std::vector<std::size_t> channels;
  float activation = 0;
};

/// What a file may ask of a channel. A float holds 1.8 as a little less: what is written as the
/// largest activation itself is the same float, but not the same double.
Bounds within(float activation_max) {
  constexpr double kHalfStep = std::numeric_limits<float>::epsilon() / 2;
  return Bounds::between(0, activation_max * (1 + kHalfStep));
}

}  // namespace

std::vector<std::size_t> channels_named(const Face& face, std::string_view name) {
  if (const auto exact = face.channel_index(name)) return {*exact};
  std::vector<std::size_t> found;
  for (const Side side : {Side::Left, Side::Right}) {
    if (const auto sided = face.channel_index(sided_name(side, name))) {
      found.push_back(*sided);
    }
  }
  return found;
}

std::map<int, AuRecording> read_recordings(TableReader& document, const Face& face,
                                           const ChannelFinder& finder,
                                           const std::vector<std::string>& names,
                                           Problems& problems, std::vector<int>* unknown) {
  std::map<int, AuRecording> recordings;
  for (const TomlValue* table : document.tables("au")) {
    TableReader reader(*table, problems);
    AuRecording recording;
    recording.number = reader.integer("number", 0, kAuNumberMax);
    recording.note = reader.text_or("note", "");
    recording.activation.assign(face.channels.size(), 0.0F);
    std::vector<Drive> drives;
    const TomlValue* drive_table = reader.table_if("drive");
    if (drive_table != nullptr) {
      for (const auto& [name, place, value] : drive_table->entries) {
        const std::vector<std::size_t> channels = finder(name);
        if (channels.empty()) {
          const bool known = std::find(names.begin(), names.end(), name) != names.end();
          if (unknown != nullptr && known) continue;
          problems.add(place, "AU" + std::to_string(recording.number) + " drives '" +
                                  escaped(name) + "', which this face does not have" +
                                  did_you_mean(name, names));
          continue;
        }
        const Bounds bounds = within(face.channels[channels.front()].activation_max);
        TableReader field(*drive_table, problems);
        drives.push_back({channels, field.number(name, bounds)});
      }
    }
    std::stable_sort(drives.begin(), drives.end(), [](const Drive& a, const Drive& b) {
      return a.channels.size() > b.channels.size();
    });
    for (const Drive& drive : drives) {
      for (const std::size_t channel : drive.channels) {
        recording.activation[channel] = drive.activation;
      }
    }
    reader.finish();
    if (unknown != nullptr && drives.empty() && recording.number != 0) {
      unknown->push_back(recording.number);
    }
    const int number = recording.number;
    if (!recordings.emplace(number, std::move(recording)).second) {
      reader.wrong("number", std::to_string(number) + " is there twice");
    }
  }
  return recordings;
}

}  // namespace aucast::face
