#include "client/app/window/shown_face.h"

namespace aucast::app {

ShownFace::ShownFace(const face::Face& face, const SettingsSession& settings,
                     PlaybackSession& playback, EditorSession& editor, ComposerSession& composer,
                     std::vector<float>& pose)
    : face_(face),
      settings_(settings),
      playback_(playback),
      editor_(editor),
      composer_(composer),
      pose_(pose),
      idle_(face),
      hair_(face),
      activations_(pose) {}

void ShownFace::show(Shown shown, Instant now) {
  if (shown != Shown::Playback) playback_.apply(gui::Pause{}, now);
  if (shown_ == Shown::Editor && shown != Shown::Editor) editor_.put_away();
  shown_ = shown;
}

void ShownFace::change_face(const std::vector<std::string>& before, Instant now) {
  pose_.assign(face_.channels.size(), 0.0F);
  idle_.emplace(face_);
  hair_.emplace(face_);
  playback_.change_face();
  editor_.change_face(before);
  composer_.remake();
  look(now);
}

void ShownFace::look(Instant now) {
  switch (shown_) {
    case Shown::Playback:
      pose_ = playback_.activations();
      break;
    case Shown::Editor:
      pose_ = editor_.activations(now);
      break;
    case Shown::Composer:
      pose_ = composer_.activations();
      break;
  }
}

const std::vector<float>& ShownFace::activations(Instant now) {
  look(now);
  hair_->forget_before(now);
  if (shown_ == Shown::Playback && !playback_.stands()) {
    hair_->move(now, pose_);
  } else {
    hair_->put(now, pose_);
  }
  hair_sway_ = hair_->at(now);
  activations_ = pose_;
  idle_->apply(settings_.idle(), seconds(now.time_since_epoch()), activations_);
  return activations_;
}

bool ShownFace::goes_on(Instant now) const {
  const pipeline::IdleOptions idle = settings_.idle();
  return idle.blink || idle.seed || hair_->swings(now);
}

std::optional<AuFrame> ShownFace::aus() const {
  switch (shown_) {
    case Shown::Playback:
      return playback_.aus();
    case Shown::Editor:
      return editor_.aus();
    case Shown::Composer:
      break;
  }
  return composer_.aus();
}

}  // namespace aucast::app
