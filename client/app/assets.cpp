#include "client/app/assets.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include <toml++/toml.h>

#include "common/files.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

Error at(const std::filesystem::path& file, const toml::source_region& where,
         const std::string& text) {
  return {ErrorKind::BadData, at_place(file.string(), where.begin.line, where.begin.column, text)};
}

/// How classic folders spell a muscle, by our name of it.
using Spellings = std::map<std::string, std::vector<std::string>, std::less<>>;

Result<Spellings> read_spellings(const toml::table& document, const std::filesystem::path& file) {
  Spellings spellings;
  const toml::table* table = document["muscle_names"].as_table();
  if (table == nullptr) return spellings;
  for (const auto& [key, node] : *table) {
    const toml::array* list = node.as_array();
    if (list == nullptr || !list->is_homogeneous<std::string>()) {
      return at(file, node.source(), "'" + std::string(key.str()) + "' is not a list of names");
    }
    for (const toml::node& spelling : *list) {
      spellings[std::string(key.str())].push_back(spelling.value_or(std::string()));
    }
  }
  return spellings;
}

/// muscles = { name = [left, right], ... }
Result<std::vector<ExpressionMuscle>> read_muscles(const toml::node& node,
                                                   const Spellings& spellings,
                                                   const std::filesystem::path& file) {
  std::vector<ExpressionMuscle> muscles;
  const toml::table* table = node.as_table();
  if (table == nullptr) return at(file, node.source(), "'muscles' is not a table");
  for (const auto& [key, value] : *table) {
    const toml::array* pair = value.as_array();
    const bool is_pair = pair != nullptr && pair->size() == 2;
    const auto left = is_pair ? pair->get(0)->value<float>() : std::nullopt;
    const auto right = is_pair ? pair->get(1)->value<float>() : std::nullopt;
    if (!left || !right || !(*left >= 0) || !(*right >= 0)) {
      return at(file, value.source(),
                "'" + std::string(key.str()) + "' is not [left, right], each 0 or more");
    }
    ExpressionMuscle muscle{std::string(key.str()), {}, *left, *right};
    if (const auto known = spellings.find(key.str()); known != spellings.end()) {
      muscle.spellings = known->second;
    }
    muscles.push_back(std::move(muscle));
  }
  return muscles;
}

/// pad = [x, y], each -1 to 1.
Result<std::array<float, 2>> read_pad(const toml::node& node, const std::filesystem::path& file) {
  const toml::array* pair = node.as_array();
  const bool is_pair = pair != nullptr && pair->size() == 2;
  const auto x = is_pair ? pair->get(0)->value<float>() : std::nullopt;
  const auto y = is_pair ? pair->get(1)->value<float>() : std::nullopt;
  const auto fits = [](float value) { return value >= -1 && value <= 1; };
  if (!x || !y || !fits(*x) || !fits(*y)) {
    return at(file, node.source(), "'pad' is not [x, y], each -1 to 1");
  }
  return std::array{*x, *y};
}

/// One [[expression]] table.
Result<Expression> read_expression(const toml::table& table, const Spellings& spellings,
                                   const std::filesystem::path& file) {
  Expression expression;
  std::string aus = "0";
  for (const auto& [key, node] : table) {
    if (key == "muscles") {
      auto muscles = read_muscles(node, spellings, file);
      if (!muscles) return muscles.error();
      expression.muscles = std::move(*muscles);
      continue;
    }
    if (key == "pad") {
      auto pad = read_pad(node, file);
      if (!pad) return pad.error();
      expression.pad = *pad;
      continue;
    }
    const auto text = node.value<std::string>();
    if (!text) return at(file, node.source(), "'" + std::string(key.str()) + "' is not a text");
    if (key == "name") {
      expression.name = *text;
    } else if (key == "label") {
      expression.label = *text;
    } else if (key == "source") {
      expression.source = *text;
    } else if (key == "aus") {
      aus = *text;
    } else {
      return at(file, key.source(),
                "unknown key '" + std::string(key.str()) +
                    "'; known are name, label, aus, muscles, source, pad");
    }
  }
  if (expression.name.empty()) return at(file, table.source(), "an expression without name");
  if (!protocol::is_stream_name(expression.name)) {
    return at(file, table.source(),
              "'" + escaped(expression.name) +
                  "' is no name: at most 64 letters, digits, '.', '_' and '-'");
  }
  if (!table.contains("aus") && expression.muscles.empty()) {
    return at(file, table.source(), "expression '" + expression.name + "' has no aus, no muscles");
  }
  auto frame = protocol::parse_au_set(aus);
  if (!frame)
    return at(file, table.source(),
              "expression '" + expression.name + "': " + frame.error().message);
  expression.aus = *frame;
  if (expression.label.empty()) expression.label = expression.name;
  return expression;
}

/// Without left_, Right_, l_ and the like.
std::string_view without_side(std::string_view name) {
  for (const std::string_view side : {"left_", "right_", "Left_", "Right_", "L_", "R_"}) {
    if (name.starts_with(side)) return name.substr(side.size());
  }
  return name;
}

bool is_muscle(const face::Channel& channel, const ExpressionMuscle& muscle) {
  const std::string_view name = without_side(channel.name);
  return name == muscle.name || std::find(muscle.spellings.begin(), muscle.spellings.end(), name) !=
                                    muscle.spellings.end();
}

/// --face names a folder, or one of those in data/faces.
std::filesystem::path face_folder(const FaceOptions& options, const std::filesystem::path& data) {
  std::error_code ignored;
  const std::filesystem::path shipped = data / "faces" / options.face;
  const bool is_name = options.face.find('/') == std::string::npos;
  if (is_name && std::filesystem::is_directory(shipped, ignored)) return shipped;
  return options.face;
}

}  // namespace

Result<std::vector<Expression>> load_expressions(const std::filesystem::path& file) {
  auto text = read_file(file);
  if (!text) return text.error();
  std::vector<Expression> expressions;
  try {
    const toml::table table = toml::parse(*text, file.string());
    const auto spellings = read_spellings(table, file);
    if (!spellings) return spellings.error();
    std::set<std::string> names;
    const toml::array* list = table["expression"].as_array();
    if (list == nullptr) {
      return at(file, table.source(), "no [[expression]] in it");
    }
    for (const toml::node& node : *list) {
      if (!node.is_table()) return at(file, node.source(), "expression is not a table");
      auto expression = read_expression(*node.as_table(), *spellings, file);
      if (!expression) return expression.error();
      if (!names.insert(expression->name).second) {
        return at(file, node.source(), "a second expression '" + expression->name + "'");
      }
      expressions.push_back(std::move(*expression));
    }
  } catch (const toml::parse_error& error) {
    return at(file, error.source(), std::string(error.description()));
  }
  return expressions;
}

Result<std::map<int, std::string>> load_au_looks(const std::filesystem::path& file) {
  auto text = read_file(file);
  if (!text) return text.error();
  std::map<int, std::string> looks;
  try {
    const toml::table document = toml::parse(*text, file.string());
    const toml::table* table = document["looks"].as_table();
    if (table == nullptr) return at(file, document.source(), "no [looks] in it");
    for (const auto& [key, node] : *table) {
      const auto words = node.value<std::string>();
      if (!words) return at(file, node.source(), "'" + std::string(key.str()) + "' is not a text");
      int number = 0;
      const std::string_view name = key.str();
      const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
      if (read.ec != std::errc() || read.ptr != name.data() + name.size() || number < 0 ||
          number > kAuNumberMax) {
        return at(file, key.source(), "'" + escaped(name) + "' is no AU number, 0 to 99");
      }
      looks[number] = *words;
    }
  } catch (const toml::parse_error& error) {
    return at(file, error.source(), std::string(error.description()));
  }
  return looks;
}

Result<std::unique_ptr<Assets>> load_assets(const FaceOptions& options) {
  auto data = find_data_folder(options.data);
  if (!data) return data.error();
  auto rules = face::find_rules(options.rules, *data);
  if (!rules) return rules.error();
  std::filesystem::path folder = face_folder(options, *data);
  auto face = face::load_face(folder, *data);
  if (!face) return face.error();
  auto expressions = load_expressions(*data / "expressions.toml");
  if (!expressions) return expressions.error();
  auto looks = load_au_looks(*data / "action_units.toml");
  if (!looks) return looks.error();
  for (const std::string& remark : face->remarks) spdlog::warn("{}", remark);
  auto assets = std::make_unique<Assets>();
  assets->data_folder = std::move(*data);
  assets->face_folder = std::move(folder);
  assets->face = std::move(*face);
  assets->rules = std::move(*rules);
  assets->expressions = std::move(*expressions);
  assets->au_looks = std::move(*looks);
  return assets;
}

Result<Expression> find_expression(const Assets& assets, const std::string& name) {
  std::vector<std::string> names;
  for (const Expression& expression : assets.expressions) {
    if (expression.name == name) return expression;
    names.push_back(expression.name);
  }
  std::string message = "no expression '" + escaped(name) + "'";
  if (const auto near = nearest(name, names)) message += "; did you mean " + *near + "?";
  return Error{ErrorKind::Usage, message + " (face-player pose --list names them)"};
}

Result<void> apply_muscles(const face::Face& face, const Expression& expression,
                           std::span<float> activations) {
  for (const ExpressionMuscle& muscle : expression.muscles) {
    bool found = false;
    for (std::size_t i = 0; i < face.channels.size(); ++i) {
      const face::Channel& channel = face.channels[i];
      if (!is_muscle(channel, muscle)) continue;
      found = true;
      const float value = channel.side == Side::Left    ? muscle.left
                          : channel.side == Side::Right ? muscle.right
                                                        : std::max(muscle.left, muscle.right);
      activations[i] = std::max(activations[i], std::min(value, channel.activation_max));
    }
    if (!found) {
      return Error{ErrorKind::BadData, "expression '" + expression.name + "': face " + face.name +
                                           " has no muscle '" + muscle.name + "'"};
    }
  }
  return {};
}

std::string describe(const Assets& assets, const AuFrame& aus) {
  const std::string set = protocol::format_au_set(aus);
  for (const Expression& expression : assets.expressions) {
    if (expression.muscles.empty() && protocol::format_au_set(expression.aus) == set)
      return expression.label;
  }
  return set;
}

}  // namespace aucast::app
