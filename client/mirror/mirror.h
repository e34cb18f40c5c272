#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "client/mirror/mirror_options.h"
#include "common/child.h"
#include "common/preview/orders.h"
#include "common/preview/preview_reader.h"
#include "common/result.h"
#include "common/shared.h"

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

/// A camera whose face is shown here before anybody else sees it: au-transmitter as a child.
/// Thread: one of its own; everything here from one thread.
class Mirror {
 public:
  /// Unreadable when au-transmitter is not there, Failed when it cannot be started.
  [[nodiscard]] static Result<std::unique_ptr<Mirror>> start(const MirrorOptions& options);
  /// end(), and at most kPatience later it is killed.
  ~Mirror();
  Mirror(const Mirror&) = delete;
  Mirror& operator=(const Mirror&) = delete;

  static constexpr std::chrono::milliseconds kPatience{2'500};

  /// state() then tells the result.
  void order(const preview::Order& order);
  /// Lets it end: everybody who watches is told.
  void end();
  [[nodiscard]] MirrorState state() const;

 private:
  explicit Mirror(std::unique_ptr<Child> child);
  void read();
  void take(preview::Record record);
  [[nodiscard]] std::optional<std::string> take_all(preview::PreviewReader& reader);

  struct Course {
    MirrorState state;
    bool asked_to_end = false;
    bool reading = true;  ///< the child may be given orders, and be killed
  };

  std::unique_ptr<Child> child_;
  Shared<Course> course_;
  // Comes last: it uses all of the above.
  std::jthread thread_;
};

}  // namespace aucast::mirror
