#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "common/preview/orders.h"
#include "common/preview/preview_reader.h"
#include "common/preview/seen.h"

namespace aucast::mirror {

/// What went wrong in the child, au-transmitter. The caller puts it into words.
struct Trouble {
  enum class Kind : std::uint8_t {
    None,
    Said,        ///< `said` has the program's own message
    NoPictures,  ///< no more pictures came: a film has ended, or the camera was unplugged
    Ended,       ///< the child ended without a message
    Signalled,   ///< the child was ended by `signal`
    Silent,      ///< the child does not take orders
  };
  Kind kind = Kind::None;
  std::string said{};
  int signal = 0;
};

/// What the child has reported so far.
struct MirrorState {
  preview::Listening own;  ///< where this host can play the stream; no address: not yet known
  std::shared_ptr<const preview::Seen> seen;  ///< the newest picture; null: none yet
  std::string live;                           ///< ADDR:PORT for guests; empty: it is not live
  std::size_t watching = 0;                   ///< how many guests watch
  Trouble refused;                            ///< why the last order was not carried out
  bool over = false;                          ///< the child has ended
  Trouble ended;                              ///< why the child ended; None if it was asked to end
};

/// The user's own camera as the window knows it: a Mirror, or a substitute in tests.
/// Thread: the player's.
class OwnCamera {
 public:
  OwnCamera() = default;
  virtual ~OwnCamera() = default;
  OwnCamera(const OwnCamera&) = delete;
  OwnCamera& operator=(const OwnCamera&) = delete;

  /// Gives the child an order. The result shows in state().
  virtual void order(const preview::Order& order) = 0;
  /// Asks the child to end. The child first lets its guests know.
  virtual void end() = 0;
  [[nodiscard]] virtual MirrorState state() const = 0;
};

}  // namespace aucast::mirror
