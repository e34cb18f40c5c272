// The functions that player_engine.js calls. A text that is returned is valid until the next call
// of a function that returns a text. An error that is empty means success.
#include <emscripten/emscripten.h>

#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include "client/view/viewpoint.h"
#include "client/web/browser.h"
#include "client/web/page.h"
#include "client/web/socket_link.h"
#include "client/web/timer.h"
#include "common/action_unit.h"
#include "protocol/codec.h"

namespace {

using aucast::web::Page;

std::unique_ptr<Page>& page() {
  static std::unique_ptr<Page> the_one;
  return the_one;
}

const char* kept(std::string& place, std::string text) {
  place = std::move(text);
  return place.c_str();
}

template <typename T>
const char* error_of(const aucast::Result<T>& result) {
  static std::string words;
  return kept(words, result ? std::string() : result.error().message);
}

/// "Cheek Raiser 80 %, left Lip Corner Puller 40 %"; for screen readers.
std::string in_words(const aucast::AuFrame& frame) {
  std::string words;
  for (const aucast::AuTerm& term : aucast::canonical_terms(frame)) {
    if (term.number == 0) continue;
    const auto name = aucast::facs_name(term.number);
    words += words.empty() ? "" : ", ";
    if (term.side != aucast::Side::Both) {
      words += term.side == aucast::Side::Left ? "left " : "right ";
    }
    words += name ? std::string(*name) : "AU " + std::to_string(term.number);
    if (term.percent < 100) words += " " + std::to_string(term.percent) + " %";
  }
  return words.empty() ? "neutral" : words;
}

}  // namespace

extern "C" {

/// Call it once the face's files are in /data.
EMSCRIPTEN_KEEPALIVE const char* aucast_create(const char* face) {
  if (!aucast::web::browser::make_context()) return "this browser has no WebGL 2";
  auto made = Page::create(face);
  if (!made) return error_of(made);
  page() = std::move(*made);
  return "";
}

/// Call it after aucast_create() and aucast_renew() until it returns 1. Each call takes a few
/// milliseconds.
EMSCRIPTEN_KEEPALIVE int aucast_make() {
  return page()->make_more() ? 1 : 0;
}

/// Call it when the canvas has a new context after having lost the old one.
EMSCRIPTEN_KEEPALIVE const char* aucast_renew() {
  return error_of(page()->renew());
}

EMSCRIPTEN_KEEPALIVE const char* aucast_show(const char* aus) {
  return error_of(page()->show(aus));
}

EMSCRIPTEN_KEEPALIVE const char* aucast_layers(const char* layers) {
  return error_of(page()->set_layers(layers));
}

EMSCRIPTEN_KEEPALIVE void aucast_play(const char* server, const char* stream, const char* token,
                                      int voice) {
  page()->play({server, stream, token, voice != 0});
}

EMSCRIPTEN_KEEPALIVE void aucast_stop() {
  page()->stop();
}

EMSCRIPTEN_KEEPALIVE void aucast_pause(int paused) {
  page()->pause(paused != 0);
}

/// Returns 1 if the face has changed and is to be drawn.
EMSCRIPTEN_KEEPALIVE int aucast_advance() {
  return page()->advance() ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void aucast_draw(int width, int height) {
  page()->draw(width, height);
}

/// RGBA, top row first; null: the driver has no room for a picture of that size.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* aucast_picture(int width, int height) {
  static aucast::Result<aucast::view::Image> image = aucast::view::Image{};
  image = page()->picture(width, height);
  return image ? image->rgba.data() : nullptr;
}

EMSCRIPTEN_KEEPALIVE void aucast_orbit(double right_px, double down_px, int height) {
  aucast::view::orbit(page()->viewpoint(), right_px, down_px, height);
}

EMSCRIPTEN_KEEPALIVE void aucast_zoom(double steps) {
  aucast::view::zoom(page()->viewpoint(), steps);
}

EMSCRIPTEN_KEEPALIVE void aucast_face_front() {
  page()->viewpoint() = aucast::view::portrait_viewpoint(aucast::view::ViewpointPreset::Front);
}

/// "idle" while no stream is open, else the state's name as in --stats.
EMSCRIPTEN_KEEPALIVE const char* aucast_state() {
  static std::string text;
  const auto state = page()->state();
  return kept(text, state ? std::string(name(*state)) : std::string("idle"));
}

/// Whether the page is connected to the server.
EMSCRIPTEN_KEEPALIVE int aucast_connected() {
  const auto* const playback = page()->playback();
  return playback != nullptr && playback->status().connected ? 1 : 0;
}

/// Whether a voice comes with the stream.
EMSCRIPTEN_KEEPALIVE int aucast_voice() {
  const auto* const playback = page()->playback();
  return playback != nullptr && playback->status().voice ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE int aucast_captions() {
  const auto* const playback = page()->playback();
  return playback != nullptr && playback->status().captions ? 1 : 0;
}

/// The title of the stream; empty: it has none, or none has come yet.
EMSCRIPTEN_KEEPALIVE const char* aucast_title() {
  static std::string text;
  const auto* const playback = page()->playback();
  return kept(text, playback != nullptr ? playback->status().title : std::string());
}

/// The caption to be shown.
EMSCRIPTEN_KEEPALIVE const char* aucast_caption() {
  return page()->caption().c_str();
}

/// Says whether what is written to the browser's sound can be heard.
EMSCRIPTEN_KEEPALIVE void aucast_sound(int on) {
  page()->set_sound(on != 0);
}

/// Percent of perceived loudness.
EMSCRIPTEN_KEEPALIVE void aucast_volume(int percent) {
  page()->sound().set_volume(percent);
}

EMSCRIPTEN_KEEPALIVE void aucast_mute(int muted) {
  page()->sound().set_muted(muted != 0);
}

/// Whether the browser's sound is the clock.
EMSCRIPTEN_KEEPALIVE int aucast_sounds() {
  return page()->sound().sounds() ? 1 : 0;
}

/// Whether the device has been given up since the last call.
EMSCRIPTEN_KEEPALIVE int aucast_sound_lost() {
  return page()->sound().take_loss() ? 1 : 0;
}

/// Call it after aucast_draw(), which must have drawn the face of the last aucast_advance().
EMSCRIPTEN_KEEPALIVE void aucast_face_shown() {
  page()->sound().face_shown();
}

/// JSON: what was played, and how far the face is from the sound that is heard (above 0 it is
/// early).
EMSCRIPTEN_KEEPALIVE const char* aucast_sound_counts() {
  static std::string text;
  const aucast::sound::SoundCounts counts = page()->sound().counts();
  const auto ms = [](aucast::Duration time) { return 1000 * aucast::seconds(time); };
  std::ostringstream json;
  json << R"({"packets":)" << counts.voice.packets << R"(,"late":)" << counts.voice.too_late
       << R"(,"underruns":)" << counts.underruns << R"(,"faces":)" << counts.shift.count
       << R"(,"shiftMs":)" << ms(counts.shift.median) << R"(,"shiftLowMs":)" << ms(counts.shift.low)
       << R"(,"shiftHighMs":)" << ms(counts.shift.high) << "}";
  return kept(text, json.str());
}

/// A sentence about why no stream comes; empty: all is well.
EMSCRIPTEN_KEEPALIVE const char* aucast_detail() {
  static std::string text;
  const auto* const playback = page()->playback();
  return kept(text, playback != nullptr ? playback->status().detail : std::string());
}

/// The code with which the server refused; 0: it did not.
EMSCRIPTEN_KEEPALIVE int aucast_refusal() {
  const auto* const playback = page()->playback();
  return playback != nullptr ? playback->status().refusal.value_or(0) : 0;
}

EMSCRIPTEN_KEEPALIVE double aucast_reconnects() {
  const auto* const playback = page()->playback();
  return playback != nullptr ? static_cast<double>(playback->status().reconnects) : 0;
}

/// The AUs that the face shows, before the rules, written as on the command line: `6,12:80`.
EMSCRIPTEN_KEEPALIVE const char* aucast_aus() {
  static std::string text;
  return kept(text, aucast::protocol::format_au_set(page()->aus()));
}

EMSCRIPTEN_KEEPALIVE const char* aucast_aus_in_words() {
  static std::string text;
  return kept(text, in_words(page()->aus()));
}

/// The keyframes that began since the last call, one per line: `6,12:80;400`.
EMSCRIPTEN_KEEPALIVE const char* aucast_begun() {
  static std::string text;
  std::string lines;
  for (const std::string& line : page()->take_begun()) lines += line + "\n";
  return kept(text, std::move(lines));
}

EMSCRIPTEN_KEEPALIVE void aucast_ask_streams(const char* server, const char* token) {
  page()->ask_streams(server, token);
}

/// "": no answer yet; "!REASON", or "=" and the streams, a line each, with tabs in between: name,
/// "live", "recorded" or nothing, length in ms or nothing, title. No text has tabs or line feeds.
EMSCRIPTEN_KEEPALIVE const char* aucast_streams() {
  static std::string text;
  const auto& answer = page()->streams();
  if (!answer) return "";
  if (!*answer) return kept(text, "!" + answer->error().message);
  std::string lines = "=";
  for (const aucast::protocol::ListedStream& stream : (*answer)->streams) {
    const char* const kind = !stream.live ? "" : *stream.live ? "live" : "recorded";
    const std::string length = stream.duration_ms ? std::to_string(*stream.duration_ms) : "";
    lines += stream.name + '\t' + kind + '\t' + length + '\t' + stream.title + '\n';
  }
  return kept(text, std::move(lines));
}

EMSCRIPTEN_KEEPALIVE void aucast_socket_opened(std::uint32_t socket) {
  aucast::web::SocketLink::opened(socket);
}

EMSCRIPTEN_KEEPALIVE void aucast_socket_received(std::uint32_t socket, const char* bytes,
                                                 std::uint32_t count) {
  aucast::web::SocketLink::received(socket, {bytes, count});
}

EMSCRIPTEN_KEEPALIVE void aucast_socket_closed(std::uint32_t socket) {
  aucast::web::SocketLink::closed(socket);
}

EMSCRIPTEN_KEEPALIVE void aucast_timer_rang(std::uint32_t timer) {
  aucast::web::Timer::ring(timer);
}
}
