#include "common/mesh/flat_buffer.h"

#include <algorithm>

namespace aucast::mesh {
namespace {

/// What std::bit_cast does, which not every C++ library has.
template <typename To, typename From>
To same_bits(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to{};
  std::memcpy(&to, &from, sizeof(to));
  return to;
}

}  // namespace

std::size_t FlatBuffer::field(std::size_t table, std::size_t index) {
  if (table == kNone) return kNone;
  const auto back = get<std::int32_t>(table);
  const auto directory = static_cast<std::int64_t>(table) - back;
  if (directory < 0) {
    broken_ = true;
    return kNone;
  }
  const auto begin = static_cast<std::size_t>(directory);
  const std::size_t entry = 4 + 2 * index;
  if (entry + 2 > get<std::uint16_t>(begin)) return kNone;
  const auto distance = get<std::uint16_t>(begin + entry);
  return distance == 0 ? kNone : table + distance;
}

std::size_t FlatBuffer::table(std::size_t table, std::size_t index) {
  const std::size_t place = field(table, index);
  return place == kNone ? kNone : target(place);
}

FlatBuffer::Items FlatBuffer::items(std::size_t table, std::size_t index, std::size_t item_bytes) {
  const std::size_t place = field(table, index);
  if (place == kNone) return {};
  const std::size_t vector = target(place);
  const std::size_t count = get<std::uint32_t>(vector);
  if (broken_) return {};
  if (count > (bytes_.size() - vector - 4) / item_bytes) {
    broken_ = true;
    return {};
  }
  return {vector + 4, count};
}

std::vector<std::int32_t> FlatBuffer::integers(std::size_t table, std::size_t index) {
  const Items found = items(table, index, 4);
  std::vector<std::int32_t> values(found.count);
  for (std::size_t item = 0; item < found.count; ++item) {
    values[item] = get<std::int32_t>(found.begin + 4 * item);
  }
  return values;
}

std::span<const std::uint8_t> FlatBuffer::bytes(std::size_t table, std::size_t index) {
  const Items found = items(table, index, 1);
  return bytes_.subspan(found.begin, found.count);
}

std::string FlatBuffer::text(std::size_t table, std::size_t index) {
  const auto found = bytes(table, index);
  return {found.begin(), found.end()};
}

namespace {

// The types of FlexBuffers that numbers can have; the lower two bits of a type's byte are the width
// of what it points to: 1, 2, 4 or 8 bytes.
enum FlexType : std::uint8_t {
  kInt = 1,
  kUInt = 2,
  kFloat = 3,
  kMap = 9,
  kVector = 10,
  kVectorInt = 11,
  kVectorUInt = 12,
  kVectorFloat = 13,
};
constexpr std::size_t kFlexItemsMax = 4096;

/// Reads values of a width that only the data knows. Once beyond the end, it stays broken.
class FlexReader {
 public:
  explicit FlexReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool broken = false;

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }

  std::uint64_t unsigned_at(std::size_t place, std::size_t width) {
    std::uint64_t value = 0;
    if (place > bytes_.size() || bytes_.size() - place < width) {
      broken = true;
      return 0;
    }
    std::memcpy(&value, bytes_.data() + place, width);
    return value;
  }

  /// What is `distance` bytes before `place`.
  std::size_t before(std::size_t place, std::uint64_t distance) {
    if (distance > place) broken = true;
    return broken ? 0 : place - static_cast<std::size_t>(distance);
  }

  double number_at(std::size_t place, std::size_t width, unsigned type) {
    const std::uint64_t bits = unsigned_at(place, width);
    if (type == kUInt) return static_cast<double>(bits);
    if (type == kFloat && width == 4) {
      return double{same_bits<float>(static_cast<std::uint32_t>(bits))};
    }
    if (type == kFloat && width == 8) return same_bits<double>(bits);
    if (type != kInt) broken = true;
    const std::size_t shift = 64 - 8 * width;
    return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
  }

  std::vector<double> numbers(std::size_t place, std::size_t width, std::uint8_t packed) {
    const unsigned type = packed >> 2U;
    if (type <= kFloat) return {number_at(place, width, type)};
    const std::size_t item_width = std::size_t{1} << (packed & 3U);
    const std::size_t begin = before(place, unsigned_at(place, width));
    const auto count = unsigned_at(before(begin, item_width), item_width);
    const bool typed = type >= kVectorInt && type <= kVectorFloat;
    if (broken || count > kFlexItemsMax || (!typed && type != kVector)) {
      broken = true;
      return {};
    }
    std::vector<double> values;
    for (std::size_t item = 0; item < count; ++item) {
      const unsigned item_type =
          typed ? type - kVectorInt + kInt
                : static_cast<unsigned>(unsigned_at(begin + count * item_width + item, 1)) >> 2U;
      values.push_back(number_at(begin + item * item_width, item_width, item_type));
    }
    return values;
  }

  std::string key_at(std::size_t place) {
    std::string key;
    for (; key.size() < 64; ++place) {
      const auto letter = static_cast<char>(unsigned_at(place, 1));
      if (broken || letter == '\0') return key;
      key += letter;
    }
    broken = true;
    return {};
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace

std::optional<FlexMap> read_flex_map(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 3) return std::nullopt;
  // The last byte is the width of the root, the one before its type, and before them is the root.
  FlexReader reader(bytes);
  const std::size_t root_width = bytes.back();
  const std::uint8_t root_type = bytes[bytes.size() - 2];
  if (root_type >> 2U != kMap || (root_width != 1 && root_width != 2 && root_width != 4)) {
    return std::nullopt;
  }
  const std::size_t root = reader.before(bytes.size() - 2, root_width);
  const std::size_t width = std::size_t{1} << (root_type & 3U);
  const std::size_t begin = reader.before(root, reader.unsigned_at(root, root_width));
  const auto count = reader.unsigned_at(reader.before(begin, width), width);
  const std::size_t keys_at = reader.before(begin, 3 * width);
  const std::size_t keys = reader.before(keys_at, reader.unsigned_at(keys_at, width));
  const auto key_width = reader.unsigned_at(reader.before(begin, 2 * width), width);
  if (reader.broken || count > 64 || (key_width != 1 && key_width != 2 && key_width != 4)) {
    return std::nullopt;
  }
  FlexMap map;
  for (std::size_t item = 0; item < count; ++item) {
    const std::size_t key = keys + item * key_width;
    const std::string name = reader.key_at(reader.before(key, reader.unsigned_at(key, key_width)));
    const auto type =
        static_cast<std::uint8_t>(reader.unsigned_at(begin + count * width + item, 1));
    map.emplace_back(name, reader.numbers(begin + item * width, width, type));
  }
  if (reader.broken) return std::nullopt;
  return map;
}

float half_to_float(std::uint16_t half) {
  const std::uint32_t sign = (half & 0x8000U) << 16U;
  const std::uint32_t exponent = (half >> 10U) & 31U;
  const std::uint32_t fraction = half & 1023U;
  if (exponent == 0) {  // a subnormal number counts in steps of 2^-24
    const float value = static_cast<float>(fraction) / 16777216.0F;
    return sign != 0 ? -value : value;
  }
  const std::uint32_t wide = exponent == 31 ? 255U : exponent + 112U;
  return same_bits<float>(sign | wide << 23U | fraction << 13U);
}

}  // namespace aucast::mesh
