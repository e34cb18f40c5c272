#include "common/camera/face_table.h"

#include <array>
#include <charconv>

namespace aucast::camera {
namespace {

void append_number(std::string& text, double value, int digits) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, digits);
  text.append(buffer.data(), end.ptr);
}

/// For Side::Both, the left one's: they are the same.
float intensity_of(const AuFrame& face, std::uint8_t number, Side side) {
  return (side == Side::Right ? face.right : face.left)[number];
}

}  // namespace

FaceTable::FaceTable(const mesh::AuWeights& weights, bool several) : several_(several) {
  if (several) header_ += ",face_id";
  using Kind = mesh::AuWeights::Kind;
  const auto add = [this](int number, Side side) {
    columns_.push_back({static_cast<std::uint8_t>(number), side});
    header_ += side == Side::Both ? "," : side == Side::Left ? ",L" : ",R";
    header_ += std::to_string(number);
  };
  for (const mesh::AuWeights::Unit& unit : weights.units) {
    if (unit.kind == Kind::Sided) {
      add(unit.number, Side::Left);
      add(unit.number, Side::Right);
      continue;
    }
    add(unit.number, Side::Both);
    if (unit.kind != Kind::Whole) add(unit.number + 1, Side::Both);
  }
  header_ += "\n";
}

std::string FaceTable::row(double seconds, double confidence, const std::optional<AuFrame>& face,
                           std::size_t number) const {
  std::string text;
  append_number(text, seconds, 4);
  text += ',';
  append_number(text, face ? confidence : 0, 3);
  text += face ? ",1" : ",0";
  if (several_) text.append(",").append(std::to_string(number));
  for (const Column& column : columns_) {
    text += ',';
    if (!face) continue;
    append_number(text, 100 * double{intensity_of(*face, column.number, column.side)}, 1);
  }
  text += '\n';
  return text;
}

std::vector<AuTerm> FaceTable::terms(const AuFrame& face) const {
  std::vector<AuTerm> terms;
  for (const Column& column : columns_) {
    const float intensity = intensity_of(face, column.number, column.side);
    terms.push_back({column.number, column.side, percent_of(intensity)});
  }
  return terms;
}

}  // namespace aucast::camera
