#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/notices.h"
#include "client/gui/editing/composer.h"
#include "client/gui/model/gui_model.h"
#include "client/pipeline/au_mapping.h"
#include "client/playback/keyframe_list.h"
#include "common/result.h"

namespace aucast::app {

/// The composer in the window: the stream that is being made, and the face of its current keyframe.
/// The constructor's arguments must outlive it. Thread: the player's.
class ComposerSession {
 public:
  ComposerSession(const Assets& assets, const pipeline::AuMapping& mapping, Notices& notices);

  /// What the caller is to do next, who has what this class has not.
  enum class Next : std::uint8_t {
    Nothing,
    Show,  ///< the composer's face
    Play,  ///< keyframes(), of which there are some
    Save,  ///< in file() or, if that is empty, in a file that the user is asked for
  };
  /// `active`: whether the composer's face is shown; `seen`: the AUs of the face that is, nullopt
  /// if it is made of muscles.
  [[nodiscard]] Next apply(const gui::ComposerCommand& command, bool active,
                           const std::optional<AuFrame>& seen, Instant now);
  /// Call it when the mapping or its face has changed.
  void remake();
  /// Call it when the language has changed: makes all texts anew.
  void change_language() {
    rows_ = nullptr;
    list_keyframes();
  }
  /// Replaces the stream by that of a file. Undo brings the previous one back, and if that was not
  /// saved, the sentence that is returned says so; else it is empty.
  [[nodiscard]] Result<std::string> load(const std::filesystem::path& file);
  /// Saves the stream and returns a sentence about where it was saved.
  [[nodiscard]] Result<std::string> save(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<float>& activations() const { return activations_; }
  /// The AUs of the face, after the rules.
  [[nodiscard]] const AuFrame& aus() const { return aus_; }
  /// The AUs of the current keyframe, and what the face shows of them.
  [[nodiscard]] std::vector<gui::AuRow> au_rows() const;
  /// The face of a keyframe with these AUs, written as in a packet; one activation per channel.
  [[nodiscard]] std::vector<float> face_of(const std::string& aus) const;
  [[nodiscard]] bool unsaved() const { return composer_.unsaved(); }
  /// Whether a new keyframe was begun and has not been added to the stream.
  [[nodiscard]] bool begun() const { return composer_.begun(); }
  /// Whether there is a keyframe being composed: a new one that was begun, or a chosen one.
  [[nodiscard]] bool composes() const { return begun() || composer_.chosen(); }
  /// The file that the stream was loaded from or saved to; empty: none yet.
  [[nodiscard]] std::filesystem::path file() const { return composer_.file(); }
  [[nodiscard]] playback::KeyframeList keyframes() const;
  /// `active`: whether the composer's face is shown.
  [[nodiscard]] gui::ComposerView view(bool active) const;

 private:
  void list_keyframes();

  const pipeline::AuMapping& mapping_;
  Notices& notices_;
  gui::Composer composer_;
  AuFrame aus_;
  std::vector<float> activations_;
  gui::Composer::Keyframes listed_;  ///< the keyframes that rows_ and total_ show
  std::shared_ptr<const std::vector<gui::TimelineRow>> rows_;
  std::string total_;
  std::shared_ptr<const std::vector<gui::PadPoint>> pad_;
  std::optional<std::array<float, 2>> pad_at_;
};

}  // namespace aucast::app
