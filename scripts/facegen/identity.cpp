#include "scripts/facegen/identity.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "common/text.h"
#include "common/toml_reader.h"

namespace aucast::facegen {
namespace {

/// More than a head can bear, so that a slip of the pen is named.
constexpr Bounds kMeasure = Bounds::between(-20, 20);
constexpr Bounds kSize = Bounds::inside(0, kMeasure.high);
constexpr Bounds kColour = Bounds::between(0, 1);

constexpr const char* kPeople = AUCAST_PEOPLE_FOLDER;

std::filesystem::path person_file(const std::filesystem::path& people, std::string_view name) {
  return people / (std::string(name) + ".toml");
}

template <typename Owner, typename Value>
struct Named {
  std::string_view name;
  Value Owner::*member;
};

/// Left as it is by `varied`.
constexpr bool kStays = false;
constexpr bool kVaries = true;
constexpr bool kAboveZero = true;

constexpr auto kForm = std::to_array<Measure>({
    {"narrowing", &Form::narrowing},
    {"jaw_width", &Form::jaw_width},
    {"jaw_bow", &Form::jaw_bow},
    {"jaw_drop", &Form::jaw_drop},
    {"chin_width", &Form::chin_width},
    {"chin_drop", &Form::chin_drop},
    {"chin_forward", &Form::chin_forward},
    {"cheek", &Form::cheek},
    {"cheekbone", &Form::cheekbone},
    {"cheek_hollow", &Form::cheek_hollow},
    {"brow_ridge", &Form::brow_ridge},
    {"forehead_slope", &Form::forehead_slope, kStays},
    {"forehead_round", &Form::forehead_round, kStays},
    {"muzzle", &Form::muzzle},
    {"throat_drop", &Form::throat_drop, kStays},
    {"short_lip", &Form::short_lip, kStays},
    {"short_nose", &Form::short_nose, kStays},
    {"neck_width", &Form::neck_width, kStays, kAboveZero},
    {"larynx", &Form::larynx, kStays},
    {"collar", &Form::collar, kStays},
    {"nose_width", &Form::nose_width, kVaries, kAboveZero},
    {"bridge_width", &Form::bridge_width},
    {"nose_forward", &Form::nose_forward},
    {"nose_up", &Form::nose_up},
    {"nose_tip", &Form::nose_tip},
    {"nose_hump", &Form::nose_hump},
    {"nose_root", &Form::nose_root},
    {"ear_size", &Form::ear_size, kStays, kAboveZero},
    {"ear_up", &Form::ear_up, kStays},
    {"eye_apart", &Form::eye_apart, kStays, kAboveZero},
    {"upper_lid", &Form::upper_lid},
    {"lower_lid", &Form::lower_lid},
    {"inner_canthus_up", &Form::inner_canthus_up, kStays},
    {"outer_canthus_up", &Form::outer_canthus_up, kStays},
    {"lid_fold", &Form::lid_fold},
    {"eye_bag", &Form::eye_bag},
    {"socket", &Form::socket},
    {"inner_socket", &Form::inner_socket, kStays},
    {"lash", &Form::lash, kStays},
    {"upper_lip", &Form::upper_lip},
    {"lower_lip", &Form::lower_lip},
    {"lip_bulge", &Form::lip_bulge},
    {"cupids_bow", &Form::cupids_bow},
    {"corner_lift", &Form::corner_lift},
    {"philtrum", &Form::philtrum},
    {"brow_up", &Form::brow_up},
    {"brow_arch", &Form::brow_arch},
    {"brow_tail_drop", &Form::brow_tail_drop},
    {"brow_begin", &Form::brow_begin},
    {"brow_width", &Form::brow_width},
    {"furrow", &Form::furrow},
    {"jowl", &Form::jowl, kStays},
    {"chin_fold", &Form::chin_fold},
});

constexpr auto kLines = std::to_array<Named<ExpressionLines, double>>({
    {"depth", &ExpressionLines::depth},
    {"width", &ExpressionLines::width},
    {"uneven", &ExpressionLines::uneven},
    {"forehead_up", &ExpressionLines::forehead_up},
});

constexpr auto kAskew = std::to_array<Named<Askew, double>>({
    {"brow", &Askew::brow},
    {"mouth", &Askew::mouth},
    {"nose", &Askew::nose},
    {"chin", &Askew::chin},
});

constexpr auto kColours = std::to_array<Named<Palette, Vec3>>({
    {"skin", &Palette::skin},
    {"flush", &Palette::flush},
    {"forehead_skin", &Palette::forehead_skin},
    {"neck_skin", &Palette::neck_skin},
    {"lid_skin", &Palette::lid_skin},
    {"lid_rim", &Palette::lid_rim},
    {"lip", &Palette::lip},
    {"brow", &Palette::brow},
    {"hair", &Palette::hair},
    {"hair_light", &Palette::hair_light},
    {"iris_inner", &Palette::iris_inner},
    {"iris_outer", &Palette::iris_outer},
    {"cloth", &Palette::cloth},
    {"collar", &Palette::collar},
});

/// The numbers of an array, and of the arrays in it, go to the end of `numbers`. False: there is
/// something else in it.
bool append_numbers(const TomlValue& value, const Bounds& bounds, std::vector<double>& numbers) {
  if (value.kind == TomlValue::Kind::Array) {
    return std::all_of(value.items.begin(), value.items.end(), [&](const TomlValue& item) {
      return append_numbers(item, bounds, numbers);
    });
  }
  numbers.push_back(value.real);
  return value.is_number() && bounds.contain(value.real);
}

/// `count` numbers, in arrays of arrays as it may be; zeros when there is a mistake.
std::vector<double> numbers_of(const TomlValue& value, std::string_view key, std::size_t count,
                               const Bounds& bounds, Problems& problems) {
  std::vector<double> numbers;
  if (append_numbers(value, bounds, numbers) && numbers.size() == count) return numbers;
  problems.add(value.place, std::string(key) + " wants " + std::to_string(count) +
                                " numbers, each " + bounds.text());
  return std::vector<double>(count);
}

/// Three of the numbers.
Vec3 point_at(const std::vector<double>& numbers, std::size_t begin) {
  return {numbers[begin], numbers[begin + 1], numbers[begin + 2]};
}

template <std::size_t Count>
std::array<Vec3, Count> line_of(const std::vector<double>& numbers) {
  std::array<Vec3, Count> line{};
  for (std::size_t i = 0; i < Count; ++i) line[i] = point_at(numbers, 3 * i);
  return line;
}

/// Reads a person's tables. What a table does not have stays as it is.
class PersonReader {
 public:
  PersonReader(const TomlValue& document, Problems& problems)
      : document_(document, problems), problems_(problems) {}

  /// Empty: like nobody.
  [[nodiscard]] std::string like() { return document_.text_or("like", ""); }
  void refuse_like(const std::string& text) { document_.wrong("like", text); }

  void read(Identity& who) {
    who.varies_towards = document_.text_or("varies_towards", who.varies_towards);
    part("form", [&](TableReader& form) {
      for (const Measure& measure : kForm) {
        const Bounds& bounds = measure.above_zero ? kSize : kMeasure;
        read_real(form, measure.name, who.form.*measure.member, bounds);
      }
    });
    part("hair", [&](TableReader& hair) { read_hair(hair, who.hair); });
    part("lines", [&](TableReader& lines) {
      who.lines.seed = lines.integer_or("seed", who.lines.seed, 0, 1'000'000);
      read_named(lines, who.lines, kLines);
    });
    part("askew", [&](TableReader& askew) { read_named(askew, who.askew, kAskew); });
    part("colours", [&](TableReader& colours) {
      for (const auto& [name, member] : kColours) {
        read_point(colours, name, who.colours.*member, kColour);
      }
      read_real(colours, "beard", who.colours.beard);
      read_real(colours, "mottled", who.colours.mottled);
    });
    document_.finish();
  }

 private:
  template <typename Read>
  void part(std::string_view key, Read read) {
    const TomlValue* const table = document_.table_if(key);
    if (table == nullptr) return;
    TableReader reader(*table, problems_);
    read(reader);
    reader.finish();
  }

  static void read_real(TableReader& reader, std::string_view key, double& out,
                        const Bounds& bounds = kMeasure) {
    if (reader.has(key)) out = reader.real(key, bounds);
  }
  template <typename Owner, typename Table>
  static void read_named(TableReader& reader, Owner& owner, const Table& named) {
    for (const auto& entry : named) read_real(reader, entry.name, owner.*entry.member);
  }
  void read_point(TableReader& reader, std::string_view key, Vec3& out, const Bounds& bounds) {
    if (const TomlValue* const value = reader.value_if(key)) {
      out = point_at(numbers_of(*value, key, 3, bounds, problems_), 0);
    }
  }
  template <typename Row, typename Make>
  void read_rows(TableReader& reader, std::string_view key, std::size_t count,
                 std::vector<Row>& out, Make make) {
    const TomlValue* const value = reader.value_if(key);
    if (value == nullptr) return;
    if (value->kind != TomlValue::Kind::Array) {
      reader.wrong(key, "must be an array of rows");
      return;
    }
    out.clear();
    for (const TomlValue& row : value->items) {
      out.push_back(make(numbers_of(row, key, count, kMeasure, problems_)));
    }
  }

  void read_hair(TableReader& reader, Haircut& hair) {
    read_rows(reader, "hairline", 4, hair.hairline, [](const std::vector<double>& row) {
      return Key<Vec3>{row[0], point_at(row, 1)};
    });
    read_point(reader, "crown", hair.crown, kMeasure);
    read_rows(reader, "guides", 27, hair.guides, line_of<9>);
    read_rows(reader, "locks", 8, hair.locks, [](const std::vector<double>& row) {
      return Lock{row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7]};
    });
    read_rows(reader, "combed", 15, hair.combed, line_of<5>);
    read_real(reader, "side", hair.side);
    read_real(reader, "top", hair.top);
    hair.grey = reader.boolean_or("grey", hair.grey);
    const auto falls = [](const auto& a, const auto& b) { return a.at >= b.at; };
    const bool ascends = std::adjacent_find(hair.hairline.begin(), hair.hairline.end(), falls) ==
                         hair.hairline.end();
    if (hair.hairline.size() < 2 || !ascends) {
      reader.wrong("hairline", "must be two rows or more whose first numbers ascend");
    }
    if (hair.locks.size() > kLocks) {
      reader.wrong("locks", "must be " + std::to_string(kLocks) + " or fewer");
    }
    if (hair.guides.empty()) {
      if (hair.combed.size() >= 2) return;
      reader.wrong("combed", "must be two lines or more, unless there are guides");
    } else if (hair.guides.size() < 2) {
      reader.wrong("guides", "must be two lines or more");
    } else if (hair.locks.empty()) {
      reader.wrong("locks", "must be one or more, as there are guides");
    }
  }

  TableReader document_;
  Problems& problems_;
};

bool contains(std::span<const std::filesystem::path> files, const std::filesystem::path& wanted) {
  return std::any_of(files.begin(), files.end(), [&](const std::filesystem::path& file) {
    std::error_code gone;
    return std::filesystem::equivalent(file, wanted, gone);
  });
}

/// The person of the last file; each of the others is like the one of the file after it.
Result<Identity> read_person(std::vector<std::filesystem::path> files,
                             const std::filesystem::path& people) {
  const std::filesystem::path file = files.back();
  const auto document = read_toml(file);
  if (!document) return document.error();
  Problems problems(file.string());
  PersonReader reader(*document, problems);
  Identity who;
  if (const std::string like = reader.like(); !like.empty()) {
    auto next = person_file(people, like);
    if (contains(files, next)) {
      reader.refuse_like("leads back to '" + escaped(like) + "'");
      return problems.result().error();
    }
    files.push_back(std::move(next));
    auto base = read_person(std::move(files), people);
    if (!base) return base.error();
    who = std::move(*base);
  }
  reader.read(who);
  if (who.hair.hairline.empty()) problems.add(document->place, "neither [hair] nor like = NAME");
  if (auto good = problems.result(); !good) return good.error();
  return who;
}

}  // namespace

std::span<const Measure> form_measures() {
  return kForm;
}

Result<Identity> read_identity(const std::filesystem::path& file) {
  return read_identity(file, kPeople);
}

Result<Identity> read_identity(const std::filesystem::path& file,
                               const std::filesystem::path& people) {
  return read_person({file}, people);
}

Result<Identity> identity_named(std::string_view name) {
  std::error_code ignored;
  if (!std::filesystem::exists(person_file(kPeople, name), ignored)) {
    return Error{ErrorKind::Usage, "no person '" + escaped(name) + "' in " + kPeople};
  }
  return read_identity(person_file(kPeople, name));
}

}  // namespace aucast::facegen
