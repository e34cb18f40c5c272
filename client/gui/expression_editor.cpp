#include "client/gui/expression_editor.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace aucast::gui {
namespace {

/// More steps than anybody takes back; a step of a large face is a kilobyte.
constexpr std::size_t kStepsMax = 1000;

}  // namespace

std::optional<std::size_t> partner_of(const face::Face& face, std::size_t channel) {
  const auto [side, base] = split_side(face.channels[channel].name);
  if (side == Side::Both) return std::nullopt;
  return face.channel_index(sided_name(opposite(side), base));
}

ExpressionEditor::ExpressionEditor(const face::Face& face, const face::AuRecordings& recordings)
    : face_(face), recordings_(recordings) {
  now_.activations.assign(face.channels.size(), 0.0F);
  now_.stored = now_.activations;
}

void ExpressionEditor::step(State next) {
  if (past_.size() == kStepsMax) past_.erase(past_.begin());
  past_.push_back(std::exchange(now_, std::move(next)));
  future_.clear();
}

void ExpressionEditor::step_or_go_on(State next, bool continued) {
  if (!continued || past_.empty()) return step(std::move(next));
  now_ = std::move(next);
  future_.clear();
}

void ExpressionEditor::set(std::size_t channel, float activation, bool continued) {
  if (!std::isfinite(activation)) return;
  State next = now_;
  const auto put = [&](std::size_t index) {
    next.activations[index] = std::clamp(activation, 0.0F, face_.channels[index].activation_max);
  };
  put(channel);
  const auto partner = partner_of(face_, channel);
  if (linked_ && partner) put(*partner);
  if (next.activations == now_.activations) return;
  step_or_go_on(std::move(next), continued);
}

void ExpressionEditor::load(int au) {
  State next;
  next.au = au;
  const auto found = recordings_.find(au);
  if (found != recordings_.end()) {
    next.activations = found->second.activation;
  } else {
    next.activations.assign(face_.channels.size(), 0.0F);
  }
  next.stored = next.activations;
  step(std::move(next));
}

void ExpressionEditor::take(const std::vector<float>& activations, bool continued) {
  step_or_go_on({activations, activations, std::nullopt}, continued);
}

void ExpressionEditor::neutral() {
  State next = now_;
  std::fill(next.activations.begin(), next.activations.end(), 0.0F);
  if (next.activations != now_.activations) step(std::move(next));
}

void ExpressionEditor::revert() {
  if (!unsaved()) return;
  State next = now_;
  next.activations = next.stored;
  step(std::move(next));
}

void ExpressionEditor::saved(int au) {
  now_.au = au;
  now_.stored = now_.activations;
  // The file has changed under every step that was about this AU: going back to one of them is a
  // change that has not been saved.
  for (std::vector<State>* steps : {&past_, &future_}) {
    for (State& state : *steps) {
      if (state.au == au) state.stored = now_.stored;
    }
  }
}

void ExpressionEditor::undo() {
  if (past_.empty()) return;
  future_.push_back(std::exchange(now_, std::move(past_.back())));
  past_.pop_back();
}

void ExpressionEditor::redo() {
  if (future_.empty()) return;
  past_.push_back(std::exchange(now_, std::move(future_.back())));
  future_.pop_back();
}

}  // namespace aucast::gui
