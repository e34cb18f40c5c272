#include "client/app/assets.h"

#include <system_error>

#include <toml++/toml.h>

#include "common/files.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

Error at(const std::filesystem::path& file, const toml::source_region& where, std::string text) {
  return {ErrorKind::BadData, at_place(file.string(), where.begin.line, where.begin.column, text)};
}

/// One [[expression]] table.
Result<Expression> read_expression(const toml::table& table, const std::filesystem::path& file) {
  Expression expression;
  std::string aus;
  for (const auto& [key, node] : table) {
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
                "unknown key '" + std::string(key.str()) + "'; known are name, label, aus, source");
    }
  }
  if (expression.name.empty()) return at(file, table.source(), "an expression without name");
  auto frame = protocol::parse_au_set(aus);
  if (!frame)
    return at(file, table.source(),
              "expression '" + expression.name + "': " + frame.error().message);
  expression.aus = *frame;
  if (expression.label.empty()) expression.label = expression.name;
  return expression;
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
    const toml::array* list = table["expression"].as_array();
    if (list == nullptr) {
      return at(file, table.source(), "no [[expression]] in it");
    }
    for (const toml::node& node : *list) {
      if (!node.is_table()) return at(file, node.source(), "expression is not a table");
      auto expression = read_expression(*node.as_table(), file);
      if (!expression) return expression.error();
      expressions.push_back(std::move(*expression));
    }
  } catch (const toml::parse_error& error) {
    return at(file, error.source(), std::string(error.description()));
  }
  return expressions;
}

Result<std::unique_ptr<Assets>> load_assets(const FaceOptions& options) {
  auto data = find_data_folder(options.data);
  if (!data) return data.error();
  auto rules = face::find_rules(options.rules, *data);
  if (!rules) return rules.error();
  auto face = face::load_face(face_folder(options, *data), *data);
  if (!face) return face.error();
  auto expressions = load_expressions(*data / "expressions.toml");
  if (!expressions) return expressions.error();
  for (const std::string& remark : face->remarks) spdlog::warn("{}", remark);
  auto assets = std::make_unique<Assets>();
  assets->data_folder = std::move(*data);
  assets->face = std::move(*face);
  assets->rules = std::move(*rules);
  assets->expressions = std::move(*expressions);
  return assets;
}

Result<AuFrame> find_expression(const Assets& assets, const std::string& name) {
  std::vector<std::string> names;
  for (const Expression& expression : assets.expressions) {
    if (expression.name == name) return expression.aus;
    names.push_back(expression.name);
  }
  std::string message = "no expression '" + escaped(name) + "'";
  if (const auto near = nearest(name, names)) message += "; did you mean " + *near + "?";
  return Error{ErrorKind::Usage, message + " (face-player pose --list names them)"};
}

std::string describe(const Assets& assets, const AuFrame& aus) {
  const std::string set = protocol::format_au_set(aus);
  for (const Expression& expression : assets.expressions) {
    if (protocol::format_au_set(expression.aus) == set) return expression.label;
  }
  return set;
}

}  // namespace aucast::app
