#include "client/web/browser.h"

#include <emscripten.h>
#include <emscripten/html5.h>

#include <cstddef>

// EM_JS makes C functions of JavaScript; Module.browser is given by player_engine.js.
// clang-format off
EM_JS(int, aucast_js_context, (), {
  // Without alpha, or the page would show through translucent parts.
  return GL.createContext(Module.canvas, {majorVersion: 2, minorVersion: 0, alpha: false,
                                          antialias: true, depth: true, stencil: false});
});
EM_JS(void, aucast_js_open, (std::uint32_t socket), { Module.browser.open(socket); });
EM_JS(void, aucast_js_send, (std::uint32_t socket, const char* bytes, std::size_t count), {
  Module.browser.send(socket, UTF8ToString(bytes, count));
});
EM_JS(void, aucast_js_end, (std::uint32_t socket), { Module.browser.end(socket); });
EM_JS(void, aucast_js_drop, (std::uint32_t socket), { Module.browser.drop(socket); });
EM_JS(void, aucast_js_timer, (std::uint32_t timer, double ms), {
  Module.browser.timer(timer, ms);
});
EM_JS(void, aucast_js_write_sound, (const float* samples, std::size_t count), {
  Module.browser.writeSound(HEAPF32.slice(samples >> 2, (samples >> 2) + count));
});
EM_JS(std::size_t, aucast_js_unheard, (), { return Module.browser.unheard(); });
// clang-format on

namespace aucast::web::browser {

bool make_context() {
  const int context = aucast_js_context();
  return context > 0 && emscripten_webgl_make_context_current(context) == EMSCRIPTEN_RESULT_SUCCESS;
}

void open_socket(std::uint32_t socket) {
  aucast_js_open(socket);
}

void send(std::uint32_t socket, std::string_view bytes) {
  aucast_js_send(socket, bytes.data(), bytes.size());
}

void end_socket(std::uint32_t socket) {
  aucast_js_end(socket);
}

void drop_socket(std::uint32_t socket) {
  aucast_js_drop(socket);
}

void set_timer(std::uint32_t timer, double milliseconds) {
  aucast_js_timer(timer, milliseconds);
}

void write_sound(std::span<const float> samples) {
  aucast_js_write_sound(samples.data(), samples.size());
}

std::size_t unheard_samples() {
  return aucast_js_unheard();
}

}  // namespace aucast::web::browser
