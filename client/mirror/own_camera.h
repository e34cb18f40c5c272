#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "common/preview/orders.h"
#include "common/preview/seen.h"

namespace aucast::mirror {

/// What is wrong with au-transmitter, the child; the caller puts it into words.
struct Trouble {
  enum class Kind : std::uint8_t {
    None,
    Said,        ///< in the program's own words
    NoPictures,  ///< there were no more of them: the end of a film, a camera pulled out
    Ended,       ///< without a word
    Signalled,   ///< ended by a signal
    Silent,      ///< it does not take orders
  };
  Kind kind = Kind::None;
  std::string said{};
  int signal = 0;
};

/// What the child has told so far.
struct MirrorState {
  std::string address;  ///< ADDR:PORT where this host can play the stream; empty: not yet
  std::shared_ptr<const preview::Seen> seen;  ///< the newest; null: nothing yet
  std::string live;                           ///< ADDR:PORT for others; empty: they are not let in
  std::size_t watching = 0;                   ///< how many of them watch
  Trouble refused;                            ///< why the last order was not carried out
  bool over = false;                          ///< the child is gone
  Trouble ended;                              ///< why; nothing when it was asked to
};

/// One's own camera as the window knows it: a Mirror, or what stands in for it in tests.
class OwnCamera {
 public:
  OwnCamera() = default;
  virtual ~OwnCamera() = default;
  OwnCamera(const OwnCamera&) = delete;
  OwnCamera& operator=(const OwnCamera&) = delete;

  /// state() then tells the result.
  virtual void order(const preview::Order& order) = 0;
  /// Lets it end: everybody who watches is told.
  virtual void end() = 0;
  [[nodiscard]] virtual MirrorState state() const = 0;
};

}  // namespace aucast::mirror
