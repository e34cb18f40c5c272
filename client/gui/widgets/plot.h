#pragma once

#include <span>
#include <string>
#include <vector>

#include "client/gui/widgets/widgets.h"

namespace aucast::gui {

/// A line of a plot; values in [0,1], oldest first.
struct PlotLine {
  const std::vector<float>* values = nullptr;
  unsigned colour = 0;
  std::string label{};  ///< written beside its end; empty: none
  int marker = -1;      ///< the sign drawn along it, as in line_name(); -1: none
};

/// What is written at a plot's edges; empty: nothing.
struct PlotScale {
  float mark = 0;           ///< a level to reach, in [0,1]; 0: none
  std::string mark_text{};  ///< above the line of `mark`
  std::string top{};        ///< what a value of 1 is
  std::string begin{};      ///< at the left end, where the half minute begins
  std::string end{};        ///< at the right end, where it ends
};
/// Draws lines over the last half minute, the newest values at the right, across the whole width.
/// Returns whether it was clicked.
bool plot(const Look& look, std::span<const PlotLine> lines, float height, const PlotScale& scale);
/// Writes the name of a line in its colour, after its sign, because colours alone do not tell lines
/// apart.
void line_name(const Look& look, int marker, const std::string& name);
/// The colour of a line in a plot of several.
[[nodiscard]] unsigned colour_of_line(std::size_t index);

}  // namespace aucast::gui
