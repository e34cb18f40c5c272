#include "client/app/window/playing/mirror_session.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "client/gui/storage/home_folder.h"
#include "client/gui/texts/said_text.h"
#include "client/gui/texts/texts.h"
#include "client/mirror/host_addresses.h"
#include "client/mirror/mirror.h"
#include "common/film_name.h"
#include "common/overloaded.h"
#include "common/text.h"

namespace aucast::app {

using Phase = gui::MirrorView::Phase;

namespace {

/// What to do where there are no models; `command` fetches them. An installation has the script in
/// a folder that is named; else it is in the source.
std::string without_models(const std::string& command) {
  const char* const where = command.starts_with('/') ? "" : gui::tr("camera.in_sources");
  return gui::tr("camera.no_models", where, command);
}

std::string in_words(const mirror::Trouble& trouble, bool film) {
  using Kind = mirror::Trouble::Kind;
  switch (trouble.kind) {
    case Kind::None:
      break;
    case Kind::Said:
      if (const auto missing = gui::places_said("bad.no_models", trouble.said); !missing.empty()) {
        return without_models(missing.back());
      }
      return gui::in_used_language(trouble.said);
    case Kind::NoPictures:
      return film ? gui::tr("camera.film_over") : gui::tr("camera.no_more");
    case Kind::Ended:
      return gui::tr("camera.has_ended");
    case Kind::Signalled:
      return gui::tr("camera.signalled", trouble.signal);
    case Kind::Silent:
      return gui::tr("camera.silent");
  }
  return {};
}

/// The source with the home folder in place of the ~ with which a film's path begins.
std::string with_home(const std::string& source) {
  const std::string device = gui::device_of(source);
  return source.substr(0, source.size() - device.size()) + gui::with_home(device);
}

/// What is wrong with a file that is named in place of a camera: au-transmitter would take it for a
/// camera that is not there. Empty: nothing.
std::string problem_of(const std::string& source) {
  const std::string name = gui::device_of(source);
  const std::filesystem::path file = name;
  const bool is_path = name.find('/') != std::string::npos || is_film(file);
  if (!is_path || name.starts_with("/dev/")) return {};
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  if (!std::filesystem::exists(status)) return gui::tr("camera.no_film", name);
  if (std::filesystem::is_directory(status)) return gui::tr("camera.is_folder", name);
  constexpr std::array<std::string_view, 7> kPictures{".jpg", ".jpeg", ".png", ".gif",
                                                      ".bmp", ".tif",  ".webp"};
  const std::string ending = lowered(file.extension().string());
  const bool picture = std::find(kPictures.begin(), kPictures.end(), ending) != kPictures.end();
  return picture ? gui::tr("camera.is_picture", name) : std::string();
}

}  // namespace

MirrorSession::MirrorSession(mirror::MirrorOptions options, Start start)
    : options_(std::move(options)), start_(std::move(start)) {
  view_ = view_of_options();
}

Result<std::unique_ptr<mirror::OwnCamera>> MirrorSession::start_mirror(
    const mirror::MirrorOptions& options) {
  auto started = mirror::Mirror::start(options);
  if (!started) return started.error();
  return std::unique_ptr<mirror::OwnCamera>(*std::move(started));
}

gui::MirrorView MirrorSession::view_of_options() const {
  gui::MirrorView view;
  view.source = options_.source;
  view.addresses = mirror::host_addresses();
  view.asks_token = !options_.token.empty();
  view.asks_tls = !options_.certificate.empty();
  return view;
}

void MirrorSession::start(const std::string& source) {
  if (mirror_ != nullptr) return;
  options_.source = with_home(source);
  view_ = view_of_options();
  played_ = ending_ = false;
  view_.trouble = problem_of(options_.source);
  if (!view_.trouble.empty()) return;
  auto started = start_(options_);
  if (!started) {
    const bool missing = started.error().kind == ErrorKind::Unreadable;
    view_.trouble =
        missing ? gui::tr("camera.not_installed") : gui::in_used_language(started.error().message);
    return;
  }
  mirror_ = *std::move(started);
  view_.phase = Phase::Starting;
}

void MirrorSession::apply(const gui::MirrorCommand& command) {
  const Overloaded carry_out{
      [this](const gui::StartMirror& one) { start(one.source); },
      [this](const gui::StopMirror&) {
        if (mirror_ == nullptr) return;
        ending_ = true;
        mirror_->end();
      },
      [this](const gui::GoLive& one) {
        if (mirror_ == nullptr && !one.source.empty()) start(one.source);
        if (mirror_ == nullptr) return;
        mirror_->order(preview::GoLive{one.bind, static_cast<std::uint16_t>(one.port)});
      },
      [this](const gui::GoPrivate&) {
        if (mirror_ != nullptr) mirror_->order(preview::GoPrivate{});
      }};
  std::visit(carry_out, command);
}

Phase MirrorSession::phase(const mirror::MirrorState& state) const {
  if (state.over) return Phase::Off;
  if (ending_) return Phase::Ending;
  if (!state.live.empty()) return Phase::Live;
  return state.seen == nullptr ? Phase::Starting : Phase::Private;
}

void MirrorSession::finish() {
  mirror_.reset();
  view_.seen.reset();
  view_.phase = Phase::Off;
}

std::optional<MirrorSession::OwnServer> MirrorSession::advance() {
  if (mirror_ == nullptr) return std::nullopt;
  mirror::MirrorState state = mirror_->state();
  view_.phase = phase(state);
  const mirror::Trouble& trouble = state.over ? state.ended : state.refused;
  const bool film = gui::is_film_source(options_.source);
  view_.trouble = in_words(trouble, film);
  view_.expected = film && trouble.kind == mirror::Trouble::Kind::NoPictures;
  view_.live = std::move(state.live);
  view_.watching = state.watching;
  view_.seen = std::move(state.seen);
  if (state.over) {
    finish();
    return std::nullopt;
  }
  if (state.own.address.empty() || std::exchange(played_, true)) return std::nullopt;
  auto endpoint = protocol::parse_endpoint(state.own.address);
  if (!endpoint) {
    view_.trouble = endpoint.error().message;
    finish();
    return std::nullopt;
  }
  return OwnServer{*std::move(endpoint), std::move(state.own.token)};
}

}  // namespace aucast::app
