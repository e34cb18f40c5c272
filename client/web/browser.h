#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// What the browser does for the page: implemented in JavaScript (player_engine.js), which answers
/// by calling what exports.cpp exports. We choose the numbers that sockets and timers are known by.
/// Thread: the page's only one.
namespace aucast::web::browser {

/// Makes a WebGL 2 context for the player's canvas, which is current from then on. False: the
/// browser has none.
[[nodiscard]] bool make_context();

/// Opens the player's WebSocket; socket_opened(), socket_received() and socket_closed() follow,
/// never from within the call.
void open_socket(std::uint32_t socket);
void send(std::uint32_t socket, std::string_view bytes);
/// Closes the socket after what was sent has gone out; socket_closed() follows.
void end_socket(std::uint32_t socket);
/// Drops the socket at once; none of its calls follow.
void drop_socket(std::uint32_t socket);

/// Has timer_rang() called after so many milliseconds, never from within this call, in place of the
/// time set before. Negative: never.
void set_timer(std::uint32_t timer, double milliseconds);

/// Plays the samples after those written before; ignored while the browser does not allow sound.
void write_sound(std::span<const float> samples);
/// How many of the written samples have not been played yet.
[[nodiscard]] std::size_t unheard_samples();

}  // namespace aucast::web::browser
