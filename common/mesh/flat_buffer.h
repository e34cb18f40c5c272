#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aucast::mesh {

/// The bytes of a FlatBuffers file, read field by field. Never reads beyond the bytes: a value that
/// would lie outside is read as 0 or empty, and broken() is true from then on.
class FlatBuffer {
 public:
  /// The place of something that is missing.
  static constexpr std::size_t kNone = 0;

  explicit FlatBuffer(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool broken() const { return broken_; }

  template <typename T>
  [[nodiscard]] T get(std::size_t place) {
    T value{};
    if (place > bytes_.size() || bytes_.size() - place < sizeof(T)) {
      broken_ = true;
    } else {
      std::memcpy(&value, bytes_.data() + place, sizeof(T));
    }
    return value;
  }

  /// The place that the number at `place` points to: that number of bytes beyond `place`.
  [[nodiscard]] std::size_t target(std::size_t place) { return place + get<std::uint32_t>(place); }
  /// Where field `index` of the table at `table` is; kNone when the table does not have it.
  [[nodiscard]] std::size_t field(std::size_t table, std::size_t index);
  /// The number in a table's field; `otherwise` when the field is left out.
  template <typename T>
  [[nodiscard]] T number(std::size_t table, std::size_t index, T otherwise) {
    const std::size_t place = field(table, index);
    return place == kNone ? otherwise : get<T>(place);
  }
  /// The table that a field points to; kNone when it is left out.
  [[nodiscard]] std::size_t table(std::size_t table, std::size_t index);

  /// A vector in a table's field: where its items begin, and how many there are. All items, of
  /// `item_bytes` each, lie within the file.
  struct Items {
    std::size_t begin = kNone;
    std::size_t count = 0;
  };
  [[nodiscard]] Items items(std::size_t table, std::size_t index, std::size_t item_bytes);
  [[nodiscard]] std::vector<std::int32_t> integers(std::size_t table, std::size_t index);
  [[nodiscard]] std::span<const std::uint8_t> bytes(std::size_t table, std::size_t index);
  [[nodiscard]] std::string text(std::size_t table, std::size_t index);

 private:
  std::span<const std::uint8_t> bytes_;
  bool broken_ = false;
};

/// The numbers under each key of a FlexBuffers map whose values are numbers or vectors of numbers,
/// as the custom operators of TFLite have them; nullopt for anything else.
using FlexMap = std::vector<std::pair<std::string, std::vector<double>>>;
[[nodiscard]] std::optional<FlexMap> read_flex_map(std::span<const std::uint8_t> bytes);

/// The value of an IEEE 754 half-precision number.
[[nodiscard]] float half_to_float(std::uint16_t half);

}  // namespace aucast::mesh
