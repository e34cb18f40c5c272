#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "client/app/window/making/composer_session.h"
#include "client/app/window/making/editor_session.h"
#include "client/app/window/playing/playback_session.h"
#include "client/app/window/settings/settings_session.h"
#include "client/face/face.h"
#include "client/pipeline/hair_swing.h"
#include "client/pipeline/idle_face.h"

namespace aucast::app {

/// Which session's face the window shows.
enum class Shown : std::uint8_t { Playback, Editor, Composer };

/// The face in the window: that of one of three sessions, with its hair and its idle movements. The
/// constructor's arguments must outlive it. Thread: the player's.
class ShownFace {
 public:
  /// `pose`: the face without idle movements, one activation per channel, with which the sessions
  /// begin what they do next; only this class changes it.
  ShownFace(const face::Face& face, const SettingsSession& settings, PlaybackSession& playback,
            EditorSession& editor, ComposerSession& composer, std::vector<float>& pose);

  /// Shows the face of this session. If it is not playback's, pauses what plays.
  void show(Shown shown, Instant now);
  [[nodiscard]] bool is(Shown shown) const { return shown_ == shown; }
  /// Call it when the mapping has another face. `before`: the names of the previous face's
  /// channels.
  void change_face(const std::vector<std::string>& before, Instant now);

  /// Brings the pose to `now`.
  void look(Instant now);
  /// The face at `now`, one activation per channel. Overwritten by the next call.
  [[nodiscard]] const std::vector<float>& activations(Instant now);
  /// The face as of the last such call.
  [[nodiscard]] const std::vector<float>& activations() const { return activations_; }
  /// Where its hair hangs. It swings while the face is played, and settles when it is not; a face
  /// that is edited, or sought while it stands, is a still.
  [[nodiscard]] const face::HairSway& hair() const { return hair_sway_; }
  /// Whether hair or idle movements go on where the session's own face does not.
  [[nodiscard]] bool goes_on(Instant now) const;

  /// The AUs of which it is made, after the rules; nullopt if it is made of muscles.
  [[nodiscard]] std::optional<AuFrame> aus() const;
  /// If it is edited muscle by muscle, what it shows, in a form for file names; else empty.
  [[nodiscard]] std::string edited() const {
    return is(Shown::Editor) && !editor_.aus() ? editor_.made_of() : std::string();
  }
  /// The number of the keyframe under way, from 1; 0: none, or the face is not playback's.
  [[nodiscard]] std::uint64_t keyframe() const {
    return is(Shown::Playback) ? playback_.keyframe() : 0;
  }

 private:
  const face::Face& face_;
  const SettingsSession& settings_;
  PlaybackSession& playback_;
  EditorSession& editor_;
  ComposerSession& composer_;
  std::vector<float>& pose_;
  Shown shown_ = Shown::Playback;
  // Made anew for another face; never null.
  std::optional<pipeline::IdleFace> idle_;
  std::optional<pipeline::HairSwing> hair_;
  std::vector<float> activations_;
  face::HairSway hair_sway_;
};

}  // namespace aucast::app
