#pragma once

#include <string>

#include "client/view/image.h"

namespace aucast::test {

/// Writes the picture as the new baseline when scripts/update_golden.sh asks for it, else compares
/// with the committed one: a pixel counts when a channel differs by more than `tolerance`, and
/// `share_max` of them may. The picture is left beside the test programs when they differ.
void expect_as_baseline(const view::Image& image, const std::string& name, int tolerance,
                        double share_max);

}  // namespace aucast::test
