#include "common/expressions/expressions.h"

#include <map>
#include <set>
#include <utility>

#include "common/text.h"
#include "common/toml_reader.h"
#include "protocol/codec.h"

namespace aucast {
namespace {

/// How classic folders spell a muscle, by our name of it.
using Spellings = std::map<std::string, std::vector<std::string>, std::less<>>;

Spellings read_spellings(TableReader& document, Problems& problems) {
  Spellings spellings;
  const TomlValue* table = document.table_if("muscle_names");
  if (table == nullptr) return spellings;
  TableReader reader(*table, problems);
  for (const TomlValue::Entry& entry : table->entries) {
    spellings[entry.key] = reader.texts(entry.key);
  }
  return spellings;
}

/// muscles = { name = [left, right], ... }
std::vector<ExpressionMuscle> read_muscles(const TomlValue& table, const Spellings& spellings,
                                           Problems& problems) {
  std::vector<ExpressionMuscle> muscles;
  TableReader reader(table, problems);
  for (const TomlValue::Entry& entry : table.entries) {
    const auto [left, right] = reader.numbers<2>(entry.key, {.low = 0});
    ExpressionMuscle muscle{entry.key, {}, left, right};
    if (const auto known = spellings.find(entry.key); known != spellings.end()) {
      muscle.spellings = known->second;
    }
    muscles.push_back(std::move(muscle));
  }
  return muscles;
}

/// One [[expression]] table.
Expression read_expression(const TomlValue& table, const Spellings& spellings, Problems& problems) {
  TableReader reader(table, problems);
  Expression expression;
  expression.name = reader.text("name");
  if (!protocol::is_stream_name(expression.name)) {
    reader.wrong("name", "'" + escaped(expression.name) + "' must be " + protocol::kStreamNameRule);
  }
  expression.label = reader.text_or("label", expression.name);
  expression.source = reader.text_or("source", "");
  if (reader.has("pad")) expression.pad = reader.numbers<2>("pad", Bounds::between(-1, 1));
  if (const TomlValue* muscles = reader.table_if("muscles")) {
    expression.muscles = read_muscles(*muscles, spellings, problems);
  }
  const auto aus = protocol::parse_au_set(reader.text_or("aus", "0"));
  if (aus) {
    expression.aus = *aus;
  } else {
    reader.wrong("aus", "of expression '" + expression.name + "': " + aus.error().message);
  }
  reader.finish();
  if (expression.muscles.empty() && !reader.has("aus")) {
    problems.add(table.place, "expression '" + expression.name + "' has neither aus nor muscles");
  }
  return expression;
}

}  // namespace

Result<std::vector<Expression>> load_expressions(const std::filesystem::path& file) {
  const auto document = read_toml(file);
  if (!document) return document.error();
  Problems problems(file.string());
  TableReader reader(*document, problems);
  const Spellings spellings = read_spellings(reader, problems);
  std::vector<Expression> expressions;
  std::set<std::string> names;
  for (const TomlValue* table : reader.tables("expression")) {
    expressions.push_back(read_expression(*table, spellings, problems));
    if (names.insert(expressions.back().name).second) continue;
    problems.add(table->place, "a second expression '" + expressions.back().name + "'");
  }
  if (expressions.empty()) problems.add(document->place, "no [[expression]] in it");
  reader.finish();
  if (auto good = problems.result(); !good) return good.error();
  return expressions;
}

}  // namespace aucast
