#pragma once

#include <map>
#include <string>

namespace aucast::app {

/// Names of AUs that the user typed and has not saved yet, and names of AUs that were removed, in
/// case they are saved again.
class AuNames {
 public:
  /// `saved`: the name that the AU has been saved with; empty: none.
  void type(int number, const std::string& name, const std::string& saved);
  /// The name to save an AU with: `wanted`, else the one that was typed, else the one that it had
  /// when it was removed; empty: none.
  [[nodiscard]] std::string name_for(int number, const std::string& wanted) const;
  /// Call it when the AU was saved with its name.
  void saved(int number);
  /// Call it when the AU was removed. `name`: the name to keep for it; empty: none.
  void removed(int number, const std::string& name);
  /// Forgets what was typed.
  void revert() { typed_.clear(); }
  /// Forgets the names of removed AUs, which belong to the previous face.
  void change_face() { removed_.clear(); }

  /// Whether there is a name that was typed and not saved.
  [[nodiscard]] bool unsaved() const { return !typed_.empty(); }
  /// The names that were typed and those of removed AUs, by AU.
  [[nodiscard]] std::map<int, std::string> view() const;

 private:
  std::map<int, std::string> typed_;
  std::map<int, std::string> removed_;
};

}  // namespace aucast::app
