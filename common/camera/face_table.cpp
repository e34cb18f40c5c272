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

}  // namespace

FaceTable::FaceTable(const mesh::AuWeights& weights) {
  using Kind = mesh::AuWeights::Kind;
  const auto add = [this](std::size_t number, bool right, const char* side) {
    columns_.push_back({number, right});
    header_ += std::string(",") + side + std::to_string(number);
  };
  for (const mesh::AuWeights::Unit& unit : weights.units) {
    if (unit.kind == Kind::Sided) {
      add(unit.number, false, "L");
      add(unit.number, true, "R");
      continue;
    }
    add(unit.number, false, "");
    if (unit.kind != Kind::Whole) add(std::size_t{unit.number} + 1, false, "");
  }
  header_ += "\n";
}

std::string FaceTable::row(double seconds, double confidence,
                           const std::optional<AuFrame>& face) const {
  std::string text;
  append_number(text, seconds, 4);
  text += ',';
  append_number(text, face ? confidence : 0, 3);
  text += face ? ",1" : ",0";
  for (const Column& column : columns_) {
    text += ',';
    if (!face) continue;
    append_number(text, 100 * double{(column.right ? face->right : face->left)[column.number]}, 1);
  }
  text += '\n';
  return text;
}

}  // namespace aucast::camera
