#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/gui/model/gui_model.h"
#include "client/gui/storage/aus_file.h"
#include "client/pipeline/au_mapping.h"
#include "common/result.h"

namespace aucast::app {

/// The AUs that users record, in their own copies of faces. What is saved or removed also changes
/// the mapping's recordings. Assets and mapping must outlive it. Thread: the player's.
class OwnAus {
 public:
  OwnAus(const Assets& assets, pipeline::AuMapping& mapping);

  /// Call it when the assets have another face.
  void change_face();
  /// Whether the face is the user's copy, and this AU is new in it or differs from the original's.
  [[nodiscard]] bool differs_from_shipped(int number) const;
  /// Whether the face has this AU; for a copy, whether the face that was copied (usually a shipped
  /// one) has it.
  [[nodiscard]] bool shipped(int number) const { return shipped_.contains(number); }

  /// The AUs of the face, with what they drive and look like.
  [[nodiscard]] std::vector<gui::AuEntry> entries() const;

  /// Saves activations, one per channel, as this AU. `name`: for an AU that FACS does not name;
  /// empty: its name stays. Returns the file.
  [[nodiscard]] Result<std::filesystem::path> save(int number,
                                                   const std::vector<float>& activations,
                                                   const std::string& name);
  /// The same for several AUs: all are saved or none.
  [[nodiscard]] Result<std::filesystem::path> take(const face::AuRecordings& recordings);
  /// Removes the user's version of an AU; if the shipped face has the AU, the shipped version is
  /// used again. Only for an AU that differs_from_shipped().
  [[nodiscard]] Result<void> remove(int number);
  /// Writes an AU file that has only this AU. Returns a sentence about where it was saved.
  [[nodiscard]] Result<std::string> export_to(int number, const std::filesystem::path& file) const;

 private:
  const Assets& assets_;
  pipeline::AuMapping& mapping_;
  bool own_ = false;  ///< the face is the user's copy
  std::map<int, gui::Drive> shipped_;
};

}  // namespace aucast::app
