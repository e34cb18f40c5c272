#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/gui/model/gui_model.h"
#include "client/pipeline/au_mapping.h"
#include "common/action_unit.h"
#include "common/result.h"

namespace aucast::app {

/// What the expressions panel has chosen: an expression at a strength, or AUs that were typed, and
/// what the rules make of them. The constructor's arguments must outlive it. Thread: the player's.
class ChosenExpression {
 public:
  ChosenExpression(const Assets& assets, const pipeline::AuMapping& mapping);

  /// Chooses one of the assets' expressions, another one than before at full strength. Returns the
  /// activations of the face. Fails if the face has not all of its muscles.
  [[nodiscard]] Result<std::vector<float>> choose(std::size_t index);
  /// Chooses these AUs, and returns the activations of the face.
  [[nodiscard]] std::vector<float> put_together(const AuFrame& aus);
  /// Sets the strength. Returns the expression that must be chosen again for it; nullopt: none is
  /// chosen, and the next one gets this strength.
  [[nodiscard]] std::optional<std::size_t> set_strength(int percent);
  /// Notes that the face is no longer an expression or combined AUs.
  void clear();
  /// Makes all texts anew.
  void change_language();

  /// The AUs of which the face is made, after the rules; nullopt: it is made of something else.
  [[nodiscard]] const std::optional<AuFrame>& aus() const { return aus_; }
  /// The AUs that were asked for, and what the rules made of each.
  [[nodiscard]] const std::vector<gui::AuRow>& au_rows() const { return au_rows_; }
  /// The name of the expression; empty: none is chosen.
  [[nodiscard]] std::string name() const;
  /// One button for each expression of the assets, in their order.
  [[nodiscard]] const gui::ExpressionsView& view() const { return view_; }

 private:
  AuFrame explained(std::span<float> target);

  const Assets& assets_;
  const pipeline::AuMapping& mapping_;
  std::optional<AuFrame> aus_;
  AuFrame asked_;  ///< aus_, before the rules
  std::vector<gui::AuRow> au_rows_;
  gui::ExpressionsView view_;
  /// The expression whose strength is view_.percent; nullopt: the next one that is chosen gets that
  /// strength.
  std::optional<std::size_t> strength_of_;
};

}  // namespace aucast::app
