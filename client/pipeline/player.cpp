#include "client/pipeline/player.h"

#include "client/playback/seekable_playback.h"

namespace aucast::pipeline {

Player::Player(const AuMapping& mapping, playback::Interpolation interpolation)
    : pipeline_(mapping, interpolation), face_(pipeline_.neutral()) {}

void Player::open(playback::Playback* playback) {
  playback_ = playback;
  begun_ = false;
}

void Player::advance(Instant now, const OnBegin& on_begin) {
  if (playback_ == nullptr) return;
  while (const auto begun = playback_->advance(now)) {
    begin(*begun);
    if (on_begin) on_begin(*begun);
  }
  move();
}

void Player::begin(const playback::KeyframeBegun& begun) {
  if (begun.from) {
    // What is played in order is there already.
    if (!begun_ || pipeline_.received() != *begun.from) {
      pipeline_.begin_keyframe(*begun.from, face_);
    }
    pipeline_.at(1, face_);
  } else if (begun_) {
    pipeline_.at(begun.cut_at, face_);
  }
  pipeline_.begin_keyframe(begun.target.aus, face_);
  begun_ = true;
}

void Player::move() {
  if (begun_) pipeline_.at(playback_->progress().mu, face_);
}

void Player::remake() {
  const auto* const seekable = begun_ ? playback_->seekable() : nullptr;
  if (seekable != nullptr) {
    begun_ = false;  // as after a jump: from the face before it
    begin(seekable->under_way());
  } else {
    // Before the first keyframe too: the rules that fired are those of the mapping before.
    pipeline_.remake();
  }
  move();
}

void Player::change_face() {
  pipeline_.change_face();
  const AuFrame aus = face_.aus;
  face_ = pipeline_.neutral();
  face_.aus = aus;
  remake();
}

void Player::set_interpolation(playback::Interpolation kind) {
  pipeline_.set_interpolation(kind);
  move();
}

void Player::set_face(std::span<const float> activations) {
  face_.aus = {};
  face_.activations.assign(activations.begin(), activations.end());
}

}  // namespace aucast::pipeline
