#include "tests/golden/calibration.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "client/face/toml_points.h"

namespace aucast::test {
namespace {

using face::read_pair;
using face::read_point;

Landmark read_landmark(const TomlValue& table, Problems& problems) {
  TableReader reader(table, problems);
  Landmark landmark;
  landmark.name = reader.text("name");
  landmark.patch = reader.text_or("patch", "");
  if (landmark.patch.empty()) {
    landmark.part = reader.text("part");
    landmark.near = read_point(reader, "near");
  } else {
    if (landmark.patch != "eye" && landmark.patch != "mouth") {
      reader.wrong("patch", "must be eye or mouth");
    }
    landmark.ring = reader.integer("ring", 0, 15);
    landmark.spoke = reader.integer("spoke", 0, 31);
  }
  reader.finish();
  return landmark;
}

Way read_way(TableReader& reader) {
  static constexpr std::array<std::pair<std::string_view, Way>, 4> kWays{
      {{"up", Way::Up}, {"forward", Way::Forward}, {"out", Way::Out}, {"left", Way::Left}}};
  const std::string text = reader.text("way");
  for (const auto& [name, way] : kWays) {
    if (name == text) return way;
  }
  reader.wrong("way", "must be up, forward, out or left");
  return Way::Up;
}

Expected read_expected(const TomlValue& table, const Calibration& calibration, Problems& problems) {
  TableReader reader(table, problems);
  Expected expected;
  expected.at = reader.text("at");
  if (calibration.find(expected.at) == nullptr) reader.wrong("at", "is no landmark");
  expected.way = read_way(reader);
  const glm::vec2 mm = read_pair(reader, "mm", Bounds::between(-200, 200));
  expected.least_mm = mm.x;
  expected.most_mm = mm.y;
  if (mm.x >= mm.y) reader.wrong("mm", "must be [least, most]");
  reader.finish();
  return expected;
}

CalibratedAu read_au(const TomlValue& table, const Calibration& calibration, Problems& problems) {
  TableReader reader(table, problems);
  CalibratedAu au;
  au.number = reader.integer("number", 1, 99);
  au.sided = reader.boolean_or("sided", false);
  for (const TomlValue* row : reader.tables("expect")) {
    au.expect.push_back(read_expected(*row, calibration, problems));
  }
  if (au.expect.empty()) reader.wrong("expect", "must name at least one landmark");
  if (const TomlValue* still = reader.value_if("still")) {
    for (const TomlValue& item : still->items) {
      if (calibration.find(item.text) == nullptr) {
        problems.add(item.place, "still names '" + item.text + "', which is no landmark");
      }
      au.still.push_back(item.text);
    }
  }
  reader.finish();
  return au;
}

}  // namespace

const Landmark* Calibration::find(const std::string& name) const {
  const auto found = std::find_if(landmarks.begin(), landmarks.end(),
                                  [&name](const Landmark& l) { return l.name == name; });
  return found == landmarks.end() ? nullptr : &*found;
}

Result<Calibration> load_calibration(const std::filesystem::path& file) {
  const auto document = read_toml(file);
  if (!document) return document.error();
  Problems problems(file.string());
  TableReader reader(*document, problems);
  static_cast<void>(reader.integer("format", 1, 1));
  Calibration calibration;
  calibration.mm_per_unit = reader.number("mm_per_unit", Bounds::above(0));
  calibration.still_mm = reader.number("still_mm", Bounds::above(0));
  for (const TomlValue* table : reader.tables("landmark")) {
    Landmark landmark = read_landmark(*table, problems);
    if (calibration.find(landmark.name) != nullptr) {
      problems.add(table->place, "the landmark '" + landmark.name + "' is there twice");
    }
    calibration.landmarks.push_back(std::move(landmark));
  }
  for (const TomlValue* table : reader.tables("au")) {
    CalibratedAu au = read_au(*table, calibration, problems);
    const auto same = [&au](const CalibratedAu& other) { return other.number == au.number; };
    if (std::any_of(calibration.aus.begin(), calibration.aus.end(), same)) {
      problems.add(table->place, "AU " + std::to_string(au.number) + " is there twice");
    }
    calibration.aus.push_back(std::move(au));
  }
  if (calibration.landmarks.empty()) reader.wrong("landmark", "must be there at least once");
  if (calibration.aus.empty()) reader.wrong("au", "must be there at least once");
  if (reader.table_if("end") == nullptr) reader.wrong("[end]", "is missing: the rest is cut off");
  reader.finish();
  if (const auto result = problems.result(); !result) return result.error();
  return calibration;
}

}  // namespace aucast::test
