#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/gui/aus_file.h"
#include "client/pipeline/au_mapping.h"
#include "common/result.h"

namespace aucast::app {

/// The AUs that users record, in their own copies of faces; what is saved or removed goes into the
/// mapping's recordings too. Assets and mapping must outlive it. Thread: the player's.
class OwnAus {
 public:
  OwnAus(const Assets& assets, pipeline::AuMapping& mapping);

  /// The face of the assets has become another one.
  void change_face();
  /// The user's copy of a face has this AU, and the face that came with the player has it otherwise
  /// or not at all.
  [[nodiscard]] bool differs_from_shipped(int number) const;
  /// The face that came with the player has this AU.
  [[nodiscard]] bool shipped(int number) const { return shipped_.contains(number); }

  /// Saves activations, one per channel, as this AU; `name` is for an AU that FACS does not name,
  /// and may be empty: as it is. Returns the file.
  [[nodiscard]] Result<std::filesystem::path> save(int number,
                                                   const std::vector<float>& activations,
                                                   const std::string& name);
  /// The same with several AUs, all of them or none.
  [[nodiscard]] Result<std::filesystem::path> take(const face::AuRecordings& recordings);
  /// One's own AU goes; one that came with the player is as it came again. Only where it
  /// differs_from_shipped().
  [[nodiscard]] Result<void> remove(int number);
  /// Writes a file of AUs with this one alone. Returns a sentence about where it went.
  [[nodiscard]] Result<std::string> export_to(int number, const std::filesystem::path& file) const;

 private:
  const Assets& assets_;
  pipeline::AuMapping& mapping_;
  bool own_ = false;  ///< the face is a copy of the user's
  std::map<int, gui::Drive> shipped_;
};

}  // namespace aucast::app
