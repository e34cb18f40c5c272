#include "client/gui/model/table_settings.h"

#include <algorithm>
#include <utility>

namespace aucast::gui {

TableSettings settings_for(const TablesView& tables, const std::string& file) {
  if (tables.asked) return *tables.asked;
  if (tables.known == nullptr) return {};
  const auto found = std::find_if(tables.known->begin(), tables.known->end(),
                                  [&](const KnownTable& one) { return one.file == file; });
  return found == tables.known->end() ? TableSettings{} : found->settings;
}

void remember_table(TablesView& tables, const KnownTable& table) {
  auto known = tables.known == nullptr ? std::vector<KnownTable>{} : *tables.known;
  std::erase_if(known, [&](const KnownTable& one) { return one.file == table.file; });
  if (table.settings != TableSettings{}) known.insert(known.begin(), table);
  if (known.size() > kKnownTablesMax) known.resize(kKnownTablesMax);
  tables.known = std::make_shared<const std::vector<KnownTable>>(std::move(known));
}

}  // namespace aucast::gui
