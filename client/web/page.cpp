#include "client/web/page.h"

#include <chrono>
#include <utility>

#include "client/playback/source_playback.h"
#include "client/render/gl.h"
#include "client/view/viewpoint.h"
#include "client/web/browser_sound.h"
#include "client/web/socket_link.h"
#include "client/web/socket_source.h"
#include "protocol/codec.h"

namespace aucast::web {
namespace {

constexpr const char* kData = "/data";
constexpr Duration kAnswerTimeMax = std::chrono::seconds(10);

}  // namespace

Result<std::unique_ptr<Page>> Page::create(const std::string& face_name) {
  auto face = face::load_face(std::string(kData) + "/faces/" + face_name, kData);
  if (!face) return face.error();
  auto rules = face::find_rules("facs", kData);
  if (!rules) return rules.error();
  std::unique_ptr<Page> page(new Page(std::move(*face), std::move(*rules)));
  if (auto made = page->make_view(); !made) return made.error();
  return page;
}

Page::Page(face::Face face, face::RuleSet rules)
    : face_(std::move(face)),
      mapping_{face_, face_.recordings, std::move(rules)},
      player_(mapping_, playback::Interpolation::Linear),
      wanted_(face_.channels.size()),
      posed_(wanted_),
      hair_(face_),
      viewpoint_(view::portrait_viewpoint(view::ViewpointPreset::Front)) {}

Page::~Page() = default;

Result<void> Page::make_view() {
  auto view = app::FaceView::create_neutral(face_);
  if (!view) return view.error();
  view_ = std::move(*view);
  view_->pose(posed_, posed_hair_);
  return {};
}

Result<void> Page::renew() {
  return make_view();
}

Result<void> Page::show(std::string_view aus) {
  const auto frame = protocol::parse_au_set(aus);
  if (!frame) return frame.error();
  stop();
  std::vector<float> activations(face_.channels.size());
  static_cast<void>(mapping_.apply(*frame, activations));
  player_.open(nullptr, activations);
  aus_ = *frame;
  static_cast<void>(advance());
  return {};
}

Result<void> Page::set_layers(std::string_view layers) {
  auto parsed = view::parse_layers(layers);
  if (!parsed) return parsed.error();
  style_.layers = *parsed;
  return {};
}

void Page::play(const Wanted& wanted) {
  stop();
  playback_ = std::make_unique<playback::SourcePlayback>(
      std::make_unique<SocketSource>(wanted.server, wanted.stream, wanted.token, wanted.voice),
      playback::SourcePlayback::Options{.hold = playback::SourcePlayback::kHold});
  player_.open(playback_.get(), wanted_);
}

void Page::stop() {
  if (playback_) playback_->stop(player_.now(now()));
  player_.open(nullptr, wanted_);
  playback_.reset();
  begun_.clear();
  captions_ = {};
}

void Page::pause(bool paused) {
  if (!playback_ || playback_->over()) return;
  const Instant at = player_.now(now());
  paused ? playback_->pause(at) : playback_->resume(at);
}

void Page::set_sound(bool on) {
  sound().set_out(on ? std::make_unique<BrowserSound>() : nullptr);
}

std::optional<playback::PlaybackState> Page::state() const {
  if (!playback_) return std::nullopt;
  return playback_->over() && !player_.over() ? playback::PlaybackState::Playing
                                              : playback_->state();
}

bool Page::advance() {
  const Instant at = now();
  player_.advance(at,
                  [this](const playback::KeyframeBegun& one, Instant begin) { begun(one, begin); });
  show_what_is_heard();
  if (playback_ && playback_->eased()) aus_ = {};
  wanted_ = player_.activations();
  swing_hair(at);
  return wanted_ != posed_ || wanted_hair_ != posed_hair_;
}

/// Hair swings while a stream plays. Nobody may look after that, and AUs that are set show a still.
void Page::swing_hair(Instant now) {
  hair_.forget_before(now);
  if (!playback_) {
    hair_.rest();
  } else if (playback_->state() != playback::PlaybackState::Paused) {
    hair_.move(now, wanted_);
  } else {
    hair_.put(now, wanted_);
  }
  wanted_hair_ = hair_.at(now);
}

void Page::begun(const playback::KeyframeBegun& keyframe, Instant at) {
  begun_.add(
      {at, keyframe.target.aus,
       protocol::format_au_set(keyframe.target.aus) + ";" + std::to_string(keyframe.time.count())});
}

/// Takes AUs, lines and captions up to what is heard now: playback is ahead of it.
void Page::show_what_is_heard() {
  if (auto aus = begun_.pass(player_.sound().shown())) aus_ = *std::move(aus);
  if (!playback_) return;
  captions_.take_from(*playback_);
  if (const auto place = player_.heard_place()) captions_.move_to(*place);
}

void Page::ask_streams(const std::string& server, const std::string& token) {
  streams_.reset();
  question_ = std::make_unique<net::StreamQuestion>(
      net::StreamQuestion::Terms{.server = server, .token = token, .until = now() + kAnswerTimeMax},
      [this](Result<protocol::StreamList> answer) { streams_ = std::move(answer); });
  question_->ask(SocketLink::create());
}

/// Poses the face. Called only when it is drawn, which is less often than time is advanced for the
/// sound.
void Page::pose() {
  if (wanted_ == posed_ && wanted_hair_ == posed_hair_) return;
  posed_ = wanted_;
  posed_hair_ = wanted_hair_;
  view_->pose(posed_, posed_hair_);
}

void Page::draw(int width, int height) {
  pose();
  style_.scale = view::line_scale(height);
  view_->draw(viewpoint_, style_, width, height);
}

Result<view::Image> Page::picture(int width, int height) {
  if (auto prepared = view_->prepare(width, height, app::Sharpness::Still); !prepared) {
    return prepared.error();
  }
  pose();
  style_.scale = view::line_scale(height);
  view::Image image = view_->picture(viewpoint_, style_);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return image;
}

}  // namespace aucast::web
