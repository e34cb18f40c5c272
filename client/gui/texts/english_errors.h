#pragma once

#include <array>

#include "client/gui/texts/english_text.h"

namespace aucast::gui {

/// What comes up in English from the network and from what is written, and is put into the language
/// in use by in_used_language(): the texts are those of the code that says them, which
/// scripts/tidy.py checks.
inline constexpr std::array kEnglishErrors = std::to_array<EnglishText>({
    {"net.cannot_reach", "cannot reach {server}: {why}"},
    {"net.unreachable", "cannot be reached: {why}"},
    {"net.is_it_there",
     "{why}; is au-transmitter running there, on an address that can be reached from here?"},
    {"net.is_it_one_wait",
     "{why}; is it an au-transmitter? --connect-timeout sets how long to wait"},
    {"net.is_it_one", "{why}; is it an au-transmitter?"},
    {"net.its_log", "{why}; the server's log may say why"},
    {"net.speaks_tls", "{why}; does it speak TLS?"},
    {"net.check_name", "{why}; check the host's name"},
    {"net.in_numbers", "{why}; check the network or give the address in numbers"},
    {"net.timeout_option", "{why}; --connect-timeout sets how long to wait"},
    {"net.no_lookup", "its name could not be looked up within {time}"},
    {"net.no_answer", "no answer within {time}"},
    {"net.no_answer_in_time", "no answer in time"},
    {"net.no_address", "it has no address"},
    {"net.refused_connection", "Connection refused"},
    {"net.reset", "Connection reset by peer"},
    {"net.no_route", "No route to host"},
    {"net.no_network", "Network is unreachable"},
    {"net.timed_out", "Connection timed out"},
    {"net.unknown_name", "Name or service not known"},
    {"net.no_name_server", "Temporary failure in name resolution"},
    {"net.nameless", "No address associated with hostname"},
    {"net.server_refused", "the server refused: {answer}"},
    {"net.refused", "refused: {answer}"},
    {"net.no_such_stream", "{code} there is no stream '{stream}' here"},
    {"net.cut_packet", "the connection ended within a packet"},
    {"net.cut_stream", "the connection ended before the end of the stream, {code}"},
    {"net.silence", "nothing came from the server within {time} ms"},
    {"net.no_list", "ended the connection without a list of its streams"},
    {"net.classic_list",
     "answered without a list of its streams: it may be a classic server, with one"},
    {"net.not_protocol", "the server sent what is not the protocol: {what}"},
    {"net.token_seen", "everybody on the way could read the token; {remedy}"},
    {"net.no_tls",
     "the server does not speak TLS; leave out --tls (of aucasts:// the s), or serve with "
     "--tls-cert"},
    {"net.expired", "the server's certificate has expired on {time}"},
    {"net.not_yet",
     "the server's certificate is not valid yet; is the clock of this computer right?"},
    {"net.unknown_authority",
     "the server's certificate comes from an authority that is not known here; {option} FILE names "
     "one to believe"},
    {"net.other_host", "the server's certificate is for {names}, not for {host}"},
    {"net.cut_handshake", "the connection ended within the TLS handshake"},
    {"net.no_handshake", "no TLS handshake within {time}"},
    {"made.glb", "{file}: {size} MB, {targets} targets\n{drift}"},
    {"made.glb_moving",
     "{file}: {size} MB, {targets} targets, {samples} samples in {time} s\n{drift}"},
    {"made.drift_still",
     "farthest vertex from the face itself: median {median} mm, nine of ten below {most} mm, worst "
     "{worst} mm ({count} random faces)"},
    {"made.drift_moving",
     "farthest vertex from the face itself: median {median} mm, nine of ten below {most} mm, worst "
     "{worst} mm ({count} samples)"},
    {"made.no_glb", "stopped; no GLB file was written"},
    // Comes before "made.rows", which matches it too.
    {"bad.no_rows", "{place}: the recording has no rows"},
    {"made.row", "{format}: {rows} row"},
    {"made.rows", "{format}: {rows} rows"},
    {"made.faceless", "{found}, {rows} without a face"},
    {"made.left_out", "{found}, {rows} left out (no later time)"},
    {"made.one_face", "{found}; one of {faces} faces"},
    {"made.needs_fps",
     "{why}; say how many pictures a second there are, such as Pictures/s {number}"},
    {"made.no_times", "{format} wrote no times here"},
    {"made.no_row_times", "no row has a time"},
    {"made.one_time", "no row has a later time than the first"},
    {"made.hasty_clock", "{rate} rows a second are no camera's: Pictures/s says how many"},
    {"made.still_clock", "{rows} without a later time: Pictures/s {rate} reads them all"},
    {"made.count_row", "1 row"},
    {"made.count_rows", "{count} rows"},
    {"made.unquiet",
     "{aus}: no face at rest was taken off; leave out 'Quiet, s', or cut what is before the face "
     "is quiet"},
    {"made.unquiet_span",
     "{aus}: no face at rest was taken off; 'Quiet, s' {seconds} takes off one"},
    {"made.and_more", "{aus} and {count} more"},
    {"bad.read", "cannot be read: {why}"},
    {"bad.written", "cannot be written: {why}"},
    {"bad.no_file", "No such file or directory"},
    {"bad.not_allowed", "Permission denied"},
    {"bad.is_folder", "Is a directory"},
    {"bad.no_folder", "Not a directory"},
    {"bad.disk_full", "No space left on device"},
    {"bad.read_only", "Read-only file system"},
    {"bad.no_stream", "there is no stream: Beg_Stream, packets and End_Stream are missing"},
    {"bad.empty", "the file is empty"},
    {"bad.no_text",
     "this is not text: found the byte '{byte}'; a stream file is ASCII or UTF-8 text"},
    {"bad.no_face", "no face is seen in any row"},
    {"bad.no_camera", "there is no such camera; plug it in, or name another one or a film"},
    {"bad.cannot_listen", "cannot listen on {address}: {why}"},
    {"bad.port_taken",
     "{why}; another program has this port: stop it, or choose one with the number beside Address "
     "(0 takes any free one)"},
    {"bad.port_of_root",
     "{why}; ports below 1024 are for root: choose another with the number beside Address"},
    {"bad.address_elsewhere",
     "{why}; that is not an address of this host: choose one with Address (127.0.0.1 for this host "
     "only, 0.0.0.0 for all addresses)"},
    {"bad.address_in_use", "Address already in use"},
    {"bad.address_not_here", "Cannot assign requested address"},
    {"bad.sweep", "the sweep '{word}' is neither a set of AUs nor an expression"},
    {"bad.sweep_like",
     "the sweep '{word}' is neither a set of AUs nor an expression; did you mean {other}?"},
    // Comes last, because all of the above may have a colon too.
    {"net.at", "{server}: {why}"},
});

}  // namespace aucast::gui
