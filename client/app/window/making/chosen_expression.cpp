#include "client/app/window/making/chosen_expression.h"

#include <algorithm>
#include <utility>

#include "client/gui/model/view_text.h"
#include "client/pipeline/expression_muscles.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

std::vector<gui::ExpressionButton> buttons_of(const std::vector<Expression>& expressions) {
  using gui::ExpressionKind;
  std::vector<gui::ExpressionButton> buttons;
  for (const Expression& expression : expressions) {
    const auto same = [&](const gui::ExpressionButton& one) {
      return one.kind == ExpressionKind::Main && one.label == expression.label;
    };
    gui::ExpressionButton button{expression.label, protocol::format_au_set(expression.aus),
                                 ExpressionKind::Main, expression.source, expression.name};
    if (!expression.muscles.empty()) {
      button.kind = ExpressionKind::Macro;
    } else if (std::any_of(buttons.begin(), buttons.end(), same)) {
      button.kind = ExpressionKind::Other;
    }
    buttons.push_back(std::move(button));
  }
  return buttons;
}

}  // namespace

ChosenExpression::ChosenExpression(const Assets& assets, const pipeline::AuMapping& mapping)
    : assets_(assets), mapping_(mapping) {
  view_.buttons = buttons_of(assets.expressions);
}

Result<std::vector<float>> ChosenExpression::choose(std::size_t index) {
  // What another one was weakened to says nothing about this one.
  if (strength_of_ && *strength_of_ != index) view_.percent = 100;
  const Expression expression =
      at_strength(assets_.expressions[index], static_cast<float>(view_.percent) / 100.0F);
  std::vector<float> target = put_together(expression.aus);
  if (const auto set = pipeline::apply_muscles(mapping_.face, expression, target); !set) {
    return set.error();
  }
  view_.chosen = static_cast<int>(index);
  strength_of_ = index;
  if (expression.muscles.empty()) {
    view_.aus = protocol::format_au_set(expression.aus);
  } else {
    aus_.reset();
  }
  return target;
}

std::vector<float> ChosenExpression::put_together(const AuFrame& aus) {
  clear();
  std::vector<float> target(mapping_.face.channels.size());
  asked_ = aus;
  aus_ = explained(target);
  return target;
}

/// Sets `target` to the activations for asked_ and notes what rules changed. Returns the AUs after
/// the rules.
AuFrame ChosenExpression::explained(std::span<float> target) {
  std::vector<face::RuleFired> fired;
  const AuFrame blended = mapping_.apply(asked_, target, &fired);
  au_rows_ = gui::au_rows(asked_, blended, face::explain(fired), mapping_.recordings);
  return blended;
}

std::optional<std::size_t> ChosenExpression::set_strength(int percent) {
  view_.percent = std::clamp(percent, 0, 100);
  if (view_.chosen >= 0) return static_cast<std::size_t>(view_.chosen);
  strength_of_.reset();
  return std::nullopt;
}

void ChosenExpression::clear() {
  aus_.reset();
  au_rows_.clear();
  view_.chosen = -1;
  view_.aus.clear();
}

void ChosenExpression::change_language() {
  if (au_rows_.empty()) return;
  std::vector<float> unused(mapping_.face.channels.size());
  static_cast<void>(explained(unused));
}

std::string ChosenExpression::name() const {
  if (view_.chosen < 0) return {};
  return assets_.expressions[static_cast<std::size_t>(view_.chosen)].name;
}

}  // namespace aucast::app
