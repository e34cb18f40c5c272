#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aucast::gui {

/// How the table of a recogniser is read when it is opened.
struct TableSettings {
  int fps = 0;           ///< pictures a second, 1-1000; 0: by the table's own clock
  int rate = 0;          ///< keyframes a second, 1-100; 0: one for each row
  int gain_percent = 0;  ///< of all AUs, up to 1000; 0: as they are
  int quiet_s = 0;       ///< how long the face rests at first, which is subtracted; 0: it does not
  friend bool operator==(const TableSettings&, const TableSettings&) = default;
};

/// A table that was not read as it is. One recording's gain is no other's.
struct KnownTable {
  std::string file;
  TableSettings settings;
  friend bool operator==(const KnownTable&, const KnownTable&) = default;
};

/// How many are remembered.
inline constexpr std::size_t kKnownTablesMax = 100;

struct TablesView {
  /// Set in the dialog that is open, for the file to be opened; null: each is read as it was last.
  std::optional<TableSettings> asked;
  std::shared_ptr<const std::vector<KnownTable>> known;  ///< the last one first; null: none
  friend bool operator==(const TablesView&, const TablesView&) = default;
};

/// How this file would be read now.
[[nodiscard]] TableSettings settings_for(const TablesView& tables, const std::string& file);
/// The file was read so. What is read as it is need not be remembered.
void remember_table(TablesView& tables, const KnownTable& table);

}  // namespace aucast::gui
