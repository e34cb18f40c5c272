#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/gui/composer.h"
#include "client/gui/gui_model.h"
#include "client/pipeline/au_mapping.h"
#include "client/playback/keyframe_source.h"
#include "common/result.h"

namespace aucast::app {

/// The composer in the window: the stream that is being made, and the face of its keyframe.
/// Assets and mapping must outlive it. Thread: the player's.
class ComposerSession {
 public:
  ComposerSession(const Assets& assets, const pipeline::AuMapping& mapping);

  /// True when the composer's face is to be shown. ComposeShown, PlayComposition and
  /// SaveComposition are not carried out here: they need another face, a player and a file.
  bool apply(const gui::ComposerCommand& command);
  /// These are the AUs of the keyframe from now on.
  void take(const AuFrame& aus);
  /// The mapping has changed, or its face.
  void remake();
  /// What it says is to be in the language that is used now.
  void change_language() {
    rows_ = nullptr;
    list_keyframes();
  }
  /// Reads a stream file in place of what is there, which undo brings back.
  [[nodiscard]] Result<void> load(const std::filesystem::path& file);
  /// Returns a sentence about where it went.
  [[nodiscard]] Result<std::string> save(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<float>& activations() const { return activations_; }
  /// Of the keyframe being composed.
  [[nodiscard]] const AuFrame& aus() const { return composer_.current().aus; }
  [[nodiscard]] bool unsaved() const { return composer_.unsaved(); }
  /// Where it came from or went to; empty: nowhere yet.
  [[nodiscard]] std::filesystem::path file() const { return composer_.file(); }
  [[nodiscard]] std::vector<playback::Keyframe> keyframes() const;
  /// `active` is the caller's to set.
  [[nodiscard]] gui::ComposerView view() const;

 private:
  void list_keyframes();

  const pipeline::AuMapping& mapping_;
  gui::Composer composer_;
  std::vector<float> activations_;
  std::uint64_t listed_revision_ = 0;  ///< that rows_ and total_ are of
  std::shared_ptr<const std::vector<gui::TimelineRow>> rows_;
  std::string total_;
  std::shared_ptr<const std::vector<gui::PadPoint>> pad_;
  std::optional<std::array<float, 2>> pad_at_;
};

}  // namespace aucast::app
