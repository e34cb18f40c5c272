#include "client/gui/editing/expression_editor.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace aucast::gui {

std::optional<std::size_t> partner_of(const face::Face& face, std::size_t channel) {
  const auto [side, base] = split_side(face.channels[channel].name);
  if (side == Side::Both) return std::nullopt;
  return face.channel_index(sided_name(opposite(side), base));
}

ExpressionEditor::ExpressionEditor(const face::Face& face, const face::AuRecordings& recordings)
    : face_(face), recordings_(recordings) {
  State& now = history_.now();
  now.activations.assign(face.channels.size(), 0.0F);
  now.stored = now.activations;
}

void ExpressionEditor::set(std::size_t channel, float activation, bool continued) {
  if (!std::isfinite(activation)) return;
  State next = history_.now();
  const auto put = [&](std::size_t index) {
    next.activations[index] = std::clamp(activation, 0.0F, face_.channels[index].activation_max);
  };
  put(channel);
  const auto partner = partner_of(face_, channel);
  if (linked_ && partner) put(*partner);
  if (next.activations == history_.now().activations) return;
  history_.step(std::move(next), continued);
}

/// The recording of an AU; the neutral face if it has none.
std::vector<float> ExpressionEditor::recording_of(int au) const {
  const auto found = recordings_.find(au);
  if (found != recordings_.end()) return found->second.activation;
  return std::vector<float>(face_.channels.size());
}

void ExpressionEditor::load(int au) {
  State next;
  next.au = au;
  next.activations = recording_of(au);
  next.stored = next.activations;
  history_.step(std::move(next));
}

void ExpressionEditor::take(const std::vector<float>& activations, bool continued) {
  history_.step({activations, activations, std::nullopt}, continued);
}

void ExpressionEditor::neutral() {
  State next = history_.now();
  std::fill(next.activations.begin(), next.activations.end(), 0.0F);
  if (next.activations != history_.now().activations) history_.step(std::move(next));
}

void ExpressionEditor::revert() {
  if (!unsaved()) return;
  State next = history_.now();
  next.activations = next.stored;
  history_.step(std::move(next));
}

void ExpressionEditor::recorded_anew(int au) {
  load(au);
  history_.change_others([&](State& state) {
    if (state.au) state.stored = recording_of(*state.au);
  });
}

void ExpressionEditor::change_face(const std::vector<std::string>& before) {
  const auto carried = [&](const std::vector<float>& activations) {
    std::vector<float> now(face_.channels.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto channel = face_.channel_index(before[i]);
      if (!channel) continue;
      now[*channel] = std::min(activations[i], face_.channels[*channel].activation_max);
    }
    return now;
  };
  const auto carry = [&](State& state) {
    const bool changed = state.activations != state.stored;
    const auto recorded = state.au ? recordings_.find(*state.au) : recordings_.end();
    state.stored =
        recorded == recordings_.end() ? carried(state.stored) : recorded->second.activation;
    state.activations = changed ? carried(state.activations) : state.stored;
  };
  carry(history_.now());
  history_.change_others(carry);
}

void ExpressionEditor::saved(int au) {
  State& now = history_.now();
  now.au = au;
  now.stored = now.activations;
  // The file has changed under every step that was about this AU: going back to one of them is a
  // change that has not been saved.
  history_.change_others([&](State& state) {
    if (state.au == au) state.stored = now.stored;
  });
}

}  // namespace aucast::gui
