#pragma once

#include <string>

#include "client/view/image.h"

namespace aucast::test {

/// Writes the picture as the new baseline when scripts/update_golden.sh asks for it, else compares
/// it with the committed one. A pixel differs if one of its channels differs by more than
/// `tolerance`; at most a share of `share_max` of the pixels may differ. If more do, the picture is
/// left beside the test programs.
void expect_as_baseline(const view::Image& image, const std::string& name, int tolerance,
                        double share_max);

}  // namespace aucast::test
