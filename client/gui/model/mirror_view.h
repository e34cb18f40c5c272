#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "common/preview/seen.h"
#include "protocol/limits.h"

namespace aucast::gui {

/// The user's own camera, and who else sees the face.
struct MirrorView {
  enum class Phase : std::uint8_t {
    Off,
    Starting,  ///< no picture has come yet
    Private,   ///< only this window sees the face
    Live,      ///< others can see it too
    Ending,
  };
  Phase phase = Phase::Off;
  bool wanted = false;    ///< the window began with the camera (--mirror)
  std::string source;     ///< camera, camera:DEVICE or a film in its place
  std::string trouble;    ///< why the camera is off or could not go live, as a sentence; empty: all
                          ///< is well
  bool expected = false;  ///< `trouble` is only the end of a film: nothing is wrong
  std::string live;       ///< ADDR:PORT for guests; empty: it is not live
  std::size_t watching = 0;                   ///< how many guests watch
  std::shared_ptr<const preview::Seen> seen;  ///< the newest picture; null: none
  std::vector<std::string> addresses;         ///< addresses of this host
  bool asks_token = false;                    ///< guests must show a token
  bool asks_tls = false;                      ///< guests must use TLS
  friend bool operator==(const MirrorView&, const MirrorView&) = default;
};

/// Opens this camera.
struct StartMirror {
  std::string source;
};
struct StopMirror {};
/// Lets guests connect at this address of this host. If the camera is off, opens it first.
struct GoLive {
  std::string bind;
  int port = protocol::kDefaultPort;
  std::string source{};  ///< the camera to open if it is off
};
/// Lets no guests connect any more.
struct GoPrivate {};
using MirrorCommand = std::variant<StartMirror, StopMirror, GoLive, GoPrivate>;

/// The camera, or the film in place of one, that a source names: "talk.mp4" for "camera:talk.mp4".
[[nodiscard]] std::string device_of(const std::string& source);
/// Whether the source is a film in place of a camera: "talk.mp4", "camera:talk.mp4". It can go live
/// without being seen in private first.
[[nodiscard]] bool is_film_source(const std::string& source);

/// One AU, or two that exclude each other, as a bar from the middle to both sides.
struct AuBar {
  std::string label;     ///< "12 Lip Corner Puller", "51 52 Head Left, Right"
  int left_percent = 0;  ///< on the subject's left, or of the AU that points there
  int right_percent = 0;
  friend bool operator==(const AuBar&, const AuBar&) = default;
};

/// The bars for the AUs of a face: one per AU, but one per pair for turns of head and eyes. In a
/// pair, left comes before right and up before down.
[[nodiscard]] std::vector<AuBar> au_bars(const std::vector<AuTerm>& aus);

/// A sentence that says who sees the face: "Only you see this face.", "Live at 10.0.0.7:4650, 2
/// watch."
[[nodiscard]] std::string viewers_text(const MirrorView& view);

/// What guests need in order to see the face, in a sentence or two.
[[nodiscard]] std::string admission_text(const MirrorView& view);

}  // namespace aucast::gui
