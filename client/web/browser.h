#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// What the browser does for the page: implemented in JavaScript (player_engine.js), which answers
/// by calling what exports.cpp exports. Sockets and timers are named by numbers of ours. Thread:
/// the page's, the only one there is.
namespace aucast::web::browser {

/// A WebGL 2 context of the player's canvas, current from then on. False: there is none.
[[nodiscard]] bool make_context();

/// Opens the player's WebSocket; socket_opened(), socket_received() and socket_closed() follow,
/// never from within the call.
void open_socket(std::uint32_t socket);
void send(std::uint32_t socket, std::string_view bytes);
/// What was sent goes out first; socket_closed() still comes.
void end_socket(std::uint32_t socket);
/// Nothing more is heard of it.
void drop_socket(std::uint32_t socket);

/// timer_rang() comes after so many milliseconds, never from within the call; replaces the timer's
/// earlier time. Negative: never.
void set_timer(std::uint32_t timer, double milliseconds);

/// To be heard after what was written before; ignored while the browser lets nothing be heard.
void write_sound(std::span<const float> samples);
/// How many of the samples written have not been heard yet.
[[nodiscard]] std::size_t unheard_samples();

}  // namespace aucast::web::browser
