#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Writes small TFLite files for tests, table by table. What a table points to comes after it in
/// the file.
namespace aucast::test {

class FlatTable {
 public:
  FlatTable& number(std::size_t field, std::int32_t value) { return add(field, 4, value, nullptr); }
  FlatTable& byte(std::size_t field, std::int8_t value) { return add(field, 1, value, nullptr); }
  FlatTable& table(std::size_t field, const FlatTable& child) { return add(field, 0, 0, &child); }
  FlatTable& tables(std::size_t field, std::vector<FlatTable> children) {
    fields_.push_back({field, 2, 0, {}, {}, std::move(children)});
    return *this;
  }
  FlatTable& bytes(std::size_t field, std::string bytes) {
    fields_.push_back({field, 3, 0, {}, std::move(bytes), {}});
    return *this;
  }
  FlatTable& integers(std::size_t field, std::vector<std::int32_t> numbers) {
    fields_.push_back({field, 5, 0, std::move(numbers), {}, {}});
    return *this;
  }

  /// A whole file with this as its root.
  [[nodiscard]] std::string file(const std::string& mark = "TFL3") const {
    std::string out(4, '\0');
    out += mark;
    put(out, 0, static_cast<std::int32_t>(append(out)));
    return out;
  }

 private:
  struct Field {
    std::size_t index;
    int kind;  ///< 0 table, 1 byte, 2 tables, 3 bytes, 4 number, 5 integers
    std::int32_t value;
    std::vector<std::int32_t> numbers;
    std::string text;
    std::vector<FlatTable> children;
  };

  FlatTable& add(std::size_t field, int kind, std::int32_t value, const FlatTable* child) {
    fields_.push_back({field, kind, value, {}, {}, {}});
    if (child != nullptr) fields_.back().children.push_back(*child);
    return *this;
  }
  static void put(std::string& out, std::size_t place, std::int32_t value) {
    for (std::size_t byte = 0; byte < 4; ++byte) {
      out[place + byte] = static_cast<char>(static_cast<std::uint32_t>(value) >> (8 * byte));
    }
  }
  static void put_half(std::string& out, std::size_t place, std::size_t value) {
    out[place] = static_cast<char>(value);
    out[place + 1] = static_cast<char>(value >> 8U);
  }
  static std::size_t grow(std::string& out, std::size_t bytes) {
    while (out.size() % 4 != 0) out += '\0';
    const std::size_t begin = out.size();
    out.resize(begin + bytes, '\0');
    return begin;
  }
  static void point(std::string& out, std::size_t from, std::size_t to) {
    put(out, from, static_cast<std::int32_t>(to - from));
  }

  std::size_t append(std::string& out) const {
    std::size_t last = 0;
    for (const Field& field : fields_) last = std::max(last, field.index + 1);
    const std::size_t directory = grow(out, 4 + 2 * last);
    const std::size_t table = grow(out, 4 + 4 * fields_.size());
    put_half(out, directory, 4 + 2 * last);
    put_half(out, directory + 2, 4 + 4 * fields_.size());
    put(out, table, static_cast<std::int32_t>(table - directory));
    for (std::size_t index = 0; index < fields_.size(); ++index) {
      const Field& field = fields_[index];
      const std::size_t place = table + 4 + 4 * index;
      put_half(out, directory + 4 + 2 * field.index, place - table);
      append(out, field, place);
    }
    return table;
  }

  static void append(std::string& out, const Field& field, std::size_t place) {
    switch (field.kind) {
      case 0: {
        const std::size_t child = field.children[0].append(out);
        point(out, place, child);
        break;
      }
      case 2: {
        const std::size_t vector = grow(out, 4 + 4 * field.children.size());
        point(out, place, vector);
        put(out, vector, static_cast<std::int32_t>(field.children.size()));
        for (std::size_t child = 0; child < field.children.size(); ++child) {
          const std::size_t at = field.children[child].append(out);
          point(out, vector + 4 + 4 * child, at);
        }
        break;
      }
      case 3: {
        const std::size_t vector = grow(out, 4 + field.text.size());
        point(out, place, vector);
        put(out, vector, static_cast<std::int32_t>(field.text.size()));
        out.replace(vector + 4, field.text.size(), field.text);
        break;
      }
      case 5: {
        const std::size_t vector = grow(out, 4 + 4 * field.numbers.size());
        point(out, place, vector);
        put(out, vector, static_cast<std::int32_t>(field.numbers.size()));
        for (std::size_t number = 0; number < field.numbers.size(); ++number) {
          put(out, vector + 4 + 4 * number, field.numbers[number]);
        }
        break;
      }
      case 1:
        out[place] = static_cast<char>(field.value);
        break;
      default:
        put(out, place, field.value);
        break;
    }
  }

  std::vector<Field> fields_;
};

/// The bytes of 16 bit floats that hold small whole numbers (-2048 to 2048).
inline std::string half_bytes(const std::vector<int>& numbers) {
  std::string bytes;
  for (const int number : numbers) {
    unsigned bits = number < 0 ? 0x8000U : 0U;
    unsigned size = static_cast<unsigned>(number < 0 ? -number : number);
    if (size != 0) {
      unsigned exponent = 25;
      while (size < 1024) {
        size <<= 1U;
        --exponent;
      }
      bits |= exponent << 10U | (size & 1023U);
    }
    bytes += static_cast<char>(bits);
    bytes += static_cast<char>(bits >> 8U);
  }
  return bytes;
}

/// Input 1x2x2x1 -> a convolution 1x1 to two channels (times 2 plus 1, times -3), 16 bit weights
/// -> ReLU. `weights` and `code` can be made wrong.
struct SmallModel {
  std::vector<int> weights{2, -3};
  std::int8_t code = 3;
  std::int32_t input = 0;
  std::vector<std::int32_t> out_shape{1, 2, 2, 2};

  [[nodiscard]] std::string file() const {
    const auto tensor = [](std::vector<std::int32_t> shape, std::int8_t type, std::int32_t buffer) {
      return FlatTable().integers(0, std::move(shape)).byte(1, type).number(2, buffer);
    };
    const FlatTable graph =
        FlatTable()
            .tables(0, {tensor({1, 2, 2, 1}, 0, 0), tensor({2, 1, 1, 1}, 1, 1), tensor({2}, 1, 2),
                        tensor({2, 1, 1, 1}, 0, 0), tensor({2}, 0, 0), tensor(out_shape, 0, 0)})
            .integers(1, {0})
            .integers(2, {5})
            .tables(3, {FlatTable().number(0, 1).integers(1, {1}).integers(2, {3}),
                        FlatTable().number(0, 1).integers(1, {2}).integers(2, {4}),
                        FlatTable()
                            .number(0, 0)
                            .integers(1, {input, 3, 4})
                            .integers(2, {5})
                            .table(4, FlatTable().number(1, 1).number(2, 1).byte(3, 1))});
    return FlatTable()
        .number(0, 3)
        .tables(1, {FlatTable().byte(0, code), FlatTable().byte(0, 6)})
        .tables(2, {graph})
        .tables(4, {FlatTable(), FlatTable().bytes(0, half_bytes(weights)),
                    FlatTable().bytes(0, half_bytes({1, 0}))})
        .file();
  }
};

/// The bytes of a file, in the form that read_model() takes.
inline std::span<const std::uint8_t> bytes_of(const std::string& file) {
  return {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
}

}  // namespace aucast::test
