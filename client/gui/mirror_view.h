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

/// One's own camera, and who else sees the face.
struct MirrorView {
  enum class Phase : std::uint8_t {
    Off,
    Starting,  ///< nothing was seen yet
    Private,   ///< only this window sees the face
    Live,      ///< others can
    Ending,
  };
  Phase phase = Phase::Off;
  bool wanted = false;       ///< the window was asked to begin with it
  std::string source;        ///< camera, camera:DEVICE or what stands in for it
  std::string trouble;       ///< why it is off or was not let live, a sentence; empty: all is well
  bool expected = false;     ///< and that is how films end: nothing is wrong
  std::string live;          ///< ADDR:PORT for others; empty: they are not let in
  std::size_t watching = 0;  ///< how many of them do
  std::shared_ptr<const preview::Seen> seen;  ///< the newest picture; null: none
  std::vector<std::string> addresses;         ///< of this host
  bool asks_token = false;                    ///< others must show one
  bool asks_tls = false;                      ///< others must connect with TLS
  friend bool operator==(const MirrorView&, const MirrorView&) = default;
};

/// Opens this camera.
struct StartMirror {
  std::string source;
};
struct StopMirror {};
/// Others may connect at this address of this host. With the camera off it opens it first.
struct GoLive {
  std::string bind;
  int port = protocol::kDefaultPort;
  std::string source{};  ///< what is opened where nothing is
};
/// They may not any more.
struct GoPrivate {};
using MirrorCommand = std::variant<StartMirror, StopMirror, GoLive, GoPrivate>;

/// Whether a film stands in for a camera: "talk.mp4", "camera:talk.mp4". Nobody needs to see it in
/// private first.
[[nodiscard]] bool is_film_source(const std::string& source);

/// One AU of a face, or two that exclude each other, as a bar from the middle to both sides.
struct AuBar {
  std::string label;     ///< "12 Lip Corner Puller", "51 52 Head Left, Right"
  int left_percent = 0;  ///< on the subject's own left, or of the AU that goes there
  int right_percent = 0;
  friend bool operator==(const AuBar&, const AuBar&) = default;
};

/// Those of a face, a bar for each number; turns of head and eyes come in pairs, left before right
/// and up before down.
[[nodiscard]] std::vector<AuBar> au_bars(const std::vector<AuTerm>& aus);

/// Who sees the face, in a sentence: "Only you see this face.", "Live at 10.0.0.7:4650, 2 watch."
[[nodiscard]] std::string audience_text(const MirrorView& view);

/// What others need to see it, in a sentence or two.
[[nodiscard]] std::string admission_text(const MirrorView& view);

}  // namespace aucast::gui
