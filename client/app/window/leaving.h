#pragma once

#include <cstdint>

#include "client/gui/model/gui_commands.h"

namespace aucast::app {

/// What would be lost if the user left now.
struct Losses {
  bool unsaved = false;     ///< saving would keep it
  bool unfinished = false;  ///< cannot be saved as it is
  [[nodiscard]] bool any() const { return unsaved || unfinished; }
};

/// When the window closes, and when it asks before. It does neither itself, and saves nothing.
class Leaving {
 public:
  /// The user wants to leave: asks if something would be lost, however often this is called.
  void wish(const Losses& losses);
  /// The user has answered. If the answer is to save, call it after that: `losses` are what is
  /// left. `choosing`: the dialog of a file to save to is open.
  void answer(const gui::Leave& answer, const Losses& losses, bool choosing);
  /// A dialog of files has closed: if saving on leaving had opened it and nothing is unsaved any
  /// more, this is a further wish().
  void chosen(const Losses& losses);
  /// Call it now and then: asks no longer once nothing would be lost. The user is told how work has
  /// ended, and is to read that first, so that this does not leave.
  void look(const Losses& losses);

  [[nodiscard]] bool asks() const { return next_ == Next::Asks; }
  [[nodiscard]] bool leaves() const { return next_ == Next::Leaves; }

 private:
  enum class Next : std::uint8_t { Stays, Asks, Leaves };
  Next next_ = Next::Stays;
  bool once_saved_ = false;  ///< a file to save to is being chosen
};

}  // namespace aucast::app
