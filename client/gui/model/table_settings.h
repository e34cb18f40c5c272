#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aucast::gui {

inline constexpr int kTableFpsMax = 1000;
inline constexpr int kTableGainPercentMax = 1000;
inline constexpr int kTableNeutralMax = 60;

/// How the table of a recogniser is to be read.
struct TableSettings {
  int fps = 0;           ///< pictures a second, up to kTableFpsMax; 0: as the table's own times say
  int rate = 0;          ///< keyframes a second, 1-100; 0: one for each row
  int gain_percent = 0;  ///< gain for all AUs, up to kTableGainPercentMax; 0: none
  int neutral_s = 0;     ///< how many seconds of neutral face, up to kTableNeutralMax, the table
                         ///< begins with; that face is subtracted; 0: no face is
  friend bool operator==(const TableSettings&, const TableSettings&) = default;
};

/// A table for which settings were made. They are remembered by file, because one recording's gain
/// does not suit another.
struct KnownTable {
  std::string file;
  TableSettings settings;
  friend bool operator==(const KnownTable&, const KnownTable&) = default;
};

/// How many tables are remembered.
inline constexpr std::size_t kKnownTablesMax = 100;

struct TablesView {
  /// The settings made in the open dialog for the file to be opened; nullopt: each file is read as
  /// it was last.
  std::optional<TableSettings> asked;
  std::shared_ptr<const std::vector<KnownTable>> known;  ///< the newest first; null: none
  friend bool operator==(const TablesView&, const TablesView&) = default;
};

/// The settings with which this file would be read now.
[[nodiscard]] TableSettings settings_for(const TablesView& tables, const std::string& file);
/// Remembers how a file was read. If its settings are the defaults, the file is forgotten.
void remember_table(TablesView& tables, const KnownTable& table);

}  // namespace aucast::gui
