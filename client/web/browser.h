#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// What the browser does for the page. It is implemented in JavaScript (player_engine.js), which
/// answers by calling the functions of exports.cpp. Sockets and timers have numbers, which the
/// caller chooses.
/// Thread: the page's only one.
namespace aucast::web::browser {

/// Makes a WebGL 2 context for the player's canvas and makes it current. Returns false if the
/// browser has no WebGL 2.
[[nodiscard]] bool make_context();

/// Opens a WebSocket to the page's server. SocketLink::opened(), received() and closed() are called
/// later, never from within this call.
void open_socket(std::uint32_t socket);
void send(std::uint32_t socket, std::string_view bytes);
/// Closes the socket once everything sent has gone out. SocketLink::closed() is called then.
void end_socket(std::uint32_t socket);
/// Drops the socket at once. Nothing is called for it any more.
void drop_socket(std::uint32_t socket);

/// Makes the browser call Timer::ring() once after `milliseconds`, never from within this call.
/// This replaces the time set before; a negative time only cancels the earlier one.
void set_timer(std::uint32_t timer, double milliseconds);

/// Plays these samples after those written before. Ignored while the browser does not allow sound.
void write_sound(std::span<const float> samples);
/// How many of the written samples have not been played yet.
[[nodiscard]] std::size_t unheard_samples();

}  // namespace aucast::web::browser
