#include "client/app/assets.h"

#include <string>
#include <system_error>
#include <vector>

#include "client/gui/storage/user_face.h"
#include "common/files.h"
#include "common/log.h"
#include "common/number_of.h"
#include "common/text.h"
#include "common/toml_reader.h"
#include "protocol/codec.h"

namespace aucast::app {

std::filesystem::path face_folder(const FaceOptions& options, const std::filesystem::path& data) {
  std::error_code ignored;
  const std::filesystem::path shipped = data / "faces" / options.face;
  const bool is_name = options.face.find('/') == std::string::npos;
  if (is_name && std::filesystem::is_directory(shipped, ignored)) return shipped;
  return options.face;
}

namespace {

/// Why there is no such face: a name that nobody knows is answered with those that are known.
Result<void> check_face(const FaceOptions& options, const std::filesystem::path& data) {
  std::error_code ignored;
  const std::filesystem::path folder = face_folder(options, data);
  if (folder.has_parent_path() || std::filesystem::exists(folder, ignored)) return {};
  std::vector<std::string> names;
  std::string known;
  for (const gui::FaceEntry& face : gui::faces_in(data / "faces")) {
    names.push_back(face.name);
    known += printable(face.name) + ", ";
  }
  return Error{ErrorKind::Unreadable, "no face '" + escaped(options.face) + "' (known: " + known +
                                          "or the folder of one)" +
                                          did_you_mean(options.face, names)};
}

}  // namespace

Result<std::map<int, std::string>> load_au_looks(const std::filesystem::path& file) {
  const auto document = read_toml(file);
  if (!document) return document.error();
  Problems problems(file.string());
  TableReader reader(*document, problems);
  std::map<int, std::string> looks;
  if (const TomlValue* table = reader.table_if("looks")) {
    TableReader texts(*table, problems);
    for (const TomlValue::Entry& entry : table->entries) {
      const int number = number_of<int>(entry.key).value_or(-1);
      if (number < 0 || number > kAuNumberMax) {
        problems.add(entry.place, "'" + escaped(entry.key) + "' is not an AU number, 0 to 99");
      }
      looks[number] = texts.text(entry.key);
    }
  } else {
    problems.add(document->place, "no [looks] in it");
  }
  reader.finish();
  if (auto good = problems.result(); !good) return good.error();
  return looks;
}

Result<std::unique_ptr<Assets>> load_assets(const FaceOptions& options) {
  auto data = find_data_folder(options.data);
  if (!data) return data.error();
  auto rules = face::find_rules(options.rules, *data);
  if (!rules) return rules.error();
  if (auto known = check_face(options, *data); !known) return known.error();
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
  return Error{ErrorKind::Usage, "no expression '" + escaped(name) + "'" +
                                     did_you_mean(name, names) +
                                     " (face-player pose --list names them)"};
}

Expression at_strength(Expression expression, float strength) {
  for (float& intensity : expression.aus.left) intensity *= strength;
  for (float& intensity : expression.aus.right) intensity *= strength;
  for (ExpressionMuscle& muscle : expression.muscles) {
    muscle.left *= strength;
    muscle.right *= strength;
  }
  return expression;
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
