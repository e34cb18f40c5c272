#include "client/app/help_text.h"

#include "protocol/limits.h"

namespace aucast::app {
namespace {

constexpr std::string_view kWatch =
    R"(face-player: receives a face as Action Units and draws it

  face-player [OPTIONS] HOST[:PORT]              in a window (port 4650 unless given)
  face-player --headless [OPTIONS] HOST[:PORT]   without a display; ends with the stream
  face-player play FILE [OPTIONS]                a stream file, without a server
  face-player pose [AUS] ...                     one still       (face-player pose --help)
  face-player rules AUS ...                      AUs after rules (face-player rules --help)
  face-player gallery DIR ...                    all pictures    (face-player gallery --help)

Receiving
  --buffer N (100)  --playout N (30)  --threshold PERCENT (40)   Receiver and Playout buffer,
                      sets, and how full the first must be before playing starts
  --buffer auto | Nms by time instead: as the link needs, or so many milliseconds
  --live              lowest delay of a live stream    --live-delay MS  so much (as the link needs)
  --hold S (5)        after a stall of so long the face eases to neutral
  --stream NAME       which of the server's streams (its first)     --list   print their names
  --protocol auto|classic     classic never sends a hello
  --connect-timeout S (10)    longest wait for a connection and for its first packet
  --tls               speak TLS; --tls-ca FILE: believe these authorities, not the system's
  --tls-cert FILE  --tls-key FILE    the certificate to show where one is wanted
  --token-file FILE   shown to the server; only over TLS, to this computer or --insecure-token
  --reconnect         hold the face and try again after 1, 2, 4 ... 30 s when the server is lost
Animating
  --speed MS          time of a keyframe that brings none of its own, 1-1000
  --mixer maximum|average    --rules facs|kumar2010|none|FILE    --interpolation linear|cosine
  --blink SEED[:INTERVAL_MS[:CLOSING_MS]]: blinks (4000, 100)    --idle SEED: also looks, breathes
  --face DIR|NAME (default)         --data DIR     where faces, rules and streams are
Pictures and numbers (these run on the film clock, like --fast)
  --frames DIR        frame_000001.png ...: 50 a keyframe, or --fps N a second
  --record FILE       .mp4, .webm or .gif, 30 pictures a second unless --fps N
  --sheet FILE.png    the faces that the keyframes reach, on one page (the first 60)
  --size WxH (800x600)     --stats FILE.json     --fast   do not wait for the clock
  --background RRGGBB a plain ground behind the face
  --show LAYER[,...]  polygons, textured (the usual), transparent, wireframe, vertices, muscles,
                      jaw-tags, eye-tags
Other
  --exit-at-end       close the window when the stream ends
  --no-config         the window neither reads nor writes ~/.config/aucast/face-player.toml
  --log-level LEVEL   trace, debug, info, warning, error, off     -v more  -q less
  --help  --version

In the window (1280x800 without --size): Tab hides the panel, ? lists all keys and what the mouse
does; space pauses, s takes a picture, f full screen, q or Esc leaves. The panel connects to other
servers, shows buffers and Action Units, and edits expressions.

  face-player lecture.example.org
  face-player --headless 10.0.0.7:4650 --record talk.mp4 --stats talk.json
  face-player play six_expressions.txt --headless --frames pictures --speed 500

Exit codes: 0 done, 1 failed while running, 2 usage, 3 bad data, 4 unreadable file, 5 network.
)";

constexpr std::string_view kPlay =
    R"(face-player play: plays a stream file without a server

  face-player play FILE [OPTIONS]             in a window
  face-player play FILE --headless [OPTIONS]  without a display

  --speed MS          time of a keyframe that brings none of its own, 1-1000 (250)
  --mixer maximum|average    --rules facs|kumar2010|none|FILE    --interpolation linear|cosine
  --blink SEED[:INTERVAL_MS[:CLOSING_MS]]: blinks (4000, 100)    --idle SEED: also looks, breathes
  --face DIR|NAME (default)         --data DIR     where faces, rules and streams are
  --frames DIR        frame_000001.png ...: 50 a keyframe, or --fps N a second
  --record FILE       .mp4, .webm or .gif, 30 pictures a second unless --fps N
  --sheet FILE.png    the faces that the keyframes reach, on one page (the first 60)
  --size WxH (800x600)     --stats FILE.json     --fast   do not wait for the clock
  --background RRGGBB a plain ground behind the face
  --show LAYER[,...]  polygons, textured (the usual), transparent, wireframe, vertices, muscles,
                      jaw-tags, eye-tags
  --exit-at-end       close the window when the stream ends
  --no-config         the window neither reads nor writes ~/.config/aucast/face-player.toml
  --log-level LEVEL   trace, debug, info, warning, error, off     -v more  -q less

  face-player play talk.txt --headless --record talk.mp4
  face-player play six_expressions.txt --speed 500
)";

constexpr std::string_view kPose =
    R"(face-player pose: one still of a face, as picture, mesh or numbers

  face-player pose [AUS] [OPTIONS]

AUS as in a packet: 1,6,12 or 12:80,R14:50 or 4C+9D; L and R are the subject's own sides.
Without --png and --obj the activations that drive the face are printed.

  --expression NAME   a prototype: happiness, thesis-anger, waters-fear, ... (see --list)
  --muscle NAME=VALUE sets a muscle or another channel after the mixer; may be repeated
  --list              the channels with their ranges, the AUs and the expressions, and leave
  --png FILE          the picture           --size WxH (800x600)    --background RRGGBB
  --camera front|three-quarter|profile      where it is seen from
  --show LAYER[,...]  what is drawn (textured): polygons, textured, transparent, wireframe,
                      vertices, muscles, jaw-tags, eye-tags
  --obj FILE          the deformed skin as Wavefront OBJ, vertices in the face's own order
  --mixer maximum|average     --rules facs|kumar2010|none|FILE
  --face DIR|NAME (default)   --data DIR    where faces, rules and streams are
  --log-level LEVEL   trace, debug, info, warning, error, off     -v more  -q less

  face-player pose 6,12 --png smile.png
  face-player pose --expression sadness --camera three-quarter --png sad.png --size 1000x1250
  face-player pose 12 --show wireframe,muscles --png muscles.png
  face-player pose --muscle left_zygomaticus_major=1 --obj pull.obj
)";

constexpr std::string_view kRules =
    R"(face-player rules: what the co-occurrence rules make of a set of AUs

  face-player rules AUS [--rules facs|kumar2010|none|FILE] [--explain] [--data DIR]

Prints the set after the rules, comma separated. --explain adds a line for each rule that changed
something: on what, and where the rule comes from.
  --log-level LEVEL   trace, debug, info, warning, error, off     -v more  -q less

  face-player rules 51,52:40
  face-player rules 1,2,5,15,16,20,26 --rules kumar2010 --explain
)";

constexpr std::string_view kGallery =
    R"(face-player gallery: every Action Unit and expression as pictures with a page

  face-player gallery DIR [OPTIONS]

Writes DIR/index.html, which opens from disk, DIR/manifest.csv with a line for each picture, and the
pictures: Action Units A to E, both sides and each alone (au/), prototypes (prototypes/), pairs of
basic expressions (combinations/), the thesis' appendices A and B (appendix_b/). The same options
and face give the same bytes. DIR may be there; what an earlier run left in it stays. Stopped with
Ctrl-C it ends with code 1, without a half picture; page and manifest are written last.

  --only SECTION[,..] aus, prototypes, combinations, appendix-a, appendix-b, sweeps, coverage
  --sweep AUS|NAME    neutral, apex and back as frames, and as a video if ffmpeg is there: a set of
                      AUs, an expression, or all of both; may be repeated
  --size WxH (300x375)        --camera front|three-quarter|profile
  --background RRGGBB         a plain ground behind the face
  --show LAYER[,...]          what is drawn; as in face-player pose --help
  --mixer maximum|average     --rules facs|kumar2010|none|FILE   (appendix B shows all of them)
  --face DIR|NAME (default)   --data DIR    where faces, rules and streams are
  --log-level LEVEL   trace, debug, info, warning, error, off     -v more  -q no progress

  face-player gallery pictures
  face-player gallery stimuli --only aus --size 800x1000 --background 808080
  face-player gallery sweeps --only sweeps --sweep 12 --sweep happiness
)";

}  // namespace

std::string_view help_text(std::string_view command) {
  if (command == "play") return kPlay;
  if (command == "pose") return kPose;
  if (command == "rules") return kRules;
  if (command == "gallery") return kGallery;
  return kWatch;
}

std::string version_text() {
  return "face-player " AUCAST_VERSION " (protocol " + std::to_string(protocol::kProtocolVersion) +
         "), MIT licence\n";
}

}  // namespace aucast::app
