#include "client/app/window/settings/settings_session.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "client/app/window/settings/language_choice.h"
#include "client/app/window/settings/window_style.h"
#include "client/gui/storage/home_folder.h"
#include "common/log.h"
#include "common/overloaded.h"

namespace aucast::app {
namespace {

bool shows_something(const view::Layers& layers) {
  return std::any_of(view::kLayerNames.begin(), view::kLayerNames.end(),
                     [&](const view::LayerName& layer) { return layers.*layer.member; });
}

}  // namespace

SettingsSession::SettingsSession(const Assets& assets, const PlayerOptions& options,
                                 pipeline::AuMapping& mapping, Notices& notices, Events events)
    : assets_(assets),
      mapping_(mapping),
      notices_(notices),
      events_(std::move(events)),
      animation_{options.face.mixer, options.face.rules, options.playback.interpolation},
      idle_seed_(options.playback.idle_seed) {
  rendering_.blinking = options.playback.blink.has_value();
  rendering_.blink = options.playback.blink.value_or(playback::BlinkOptions{});
  rendering_.layers = options.output.layers;
}

void SettingsSession::begin_with(const gui::KeptSettings& kept, Instant now) {
  rendering_ = kept.rendering;
  // The window never begins with an empty view.
  if (!shows_something(rendering_.layers)) rendering_.layers = {};
  change_pictures(kept.pictures);
  change_display(kept.display, now);
  display_.languages = languages_in(assets_.data_folder);
}

void SettingsSession::keep(gui::KeptSettings& kept) const {
  kept.animation = animation_;
  kept.rendering = rendering_;
  kept.pictures = pictures_;
  // A name that is half typed would be refused at the next start.
  if (!gui::picture_name(pictures_.pattern, {}, 1)) {
    kept.pictures.pattern = gui::PictureSettings().pattern;
  }
  kept.display = display_.settings;
}

void SettingsSession::apply(const gui::SettingsCommand& command, Instant now) {
  const Overloaded carry_out{
      [&](const gui::ChangePictures& one) { change_pictures(one.settings); },
      [&](const gui::ChangeAnimation& one) { change_animation(one.settings, now); },
      [&](const gui::ChangeRendering& one) { rendering_ = one.settings; },
      [&](const gui::ChangeDisplay& one) { change_display(one.settings, now); }};
  std::visit(carry_out, command);
}

void SettingsSession::change_animation(const gui::AnimationSettings& settings, Instant now) {
  if (settings.rules != animation_.rules) {
    auto rules = face::find_rules(settings.rules, assets_.data_folder);
    if (!rules) {
      spdlog::error("{}", rules.error().message);
      return notices_.say(rules.error().message, true, now);
    }
    mapping_.rules = std::move(*rules);
  }
  animation_ = settings;
  mapping_.mixer = settings.mixer;
  events_.on_animation();
}

void SettingsSession::change_pictures(const gui::PictureSettings& settings) {
  const std::string folder = gui::with_home(settings.folder);
  const bool moved = folder != pictures_.folder;
  pictures_ = settings;
  pictures_.folder = folder;
  if (moved) events_.on_picture_folder(pictures_.folder);
}

/// If there is no language for the locale, that is no error of the user's.
void SettingsSession::change_display(const gui::DisplaySettings& settings, Instant now) {
  display_.settings = settings;
  const bool chosen = !settings.language.empty();
  const std::string code = chosen ? settings.language : language_of_locale();
  if (code == display_.language) return;
  if (const auto used = choose_language(assets_.data_folder, code)) {
    display_.language = code;
    events_.on_language();
  } else if (chosen || used.error().kind != ErrorKind::Usage) {
    spdlog::warn("{}", used.error().message);
    notices_.say(used.error().message, true, now);
  }
}

pipeline::IdleOptions SettingsSession::idle() const {
  pipeline::IdleOptions idle{idle_seed_, std::nullopt};
  if (rendering_.blinking) idle.blink = rendering_.blink;
  return idle;
}

PlayerOptions SettingsSession::applied(PlayerOptions options) const {
  options.face.rules = animation_.rules;
  options.face.mixer = animation_.mixer;
  options.output.background = plain_ground(rendering_.ground, options.output.background);
  options.output.transparent |= rendering_.ground == gui::Ground::None;
  options.output.layers = rendering_.layers;
  return options;
}

}  // namespace aucast::app
