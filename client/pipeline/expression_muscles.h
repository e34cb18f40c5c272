#pragma once

#include <span>

#include "client/face/face.h"
#include "common/expressions/expressions.h"
#include "common/result.h"

namespace aucast::pipeline {

/// Sets an expression's muscles on top of `activations` (one per channel of the face): the larger
/// value counts, limited to the channel's maximum. Fails with BadData if the face lacks one of the
/// muscles.
[[nodiscard]] Result<void> apply_muscles(const face::Face& face, const Expression& expression,
                                         std::span<float> activations);

}  // namespace aucast::pipeline
