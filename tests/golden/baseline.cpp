#include "tests/golden/baseline.h"
#include "tests/support/image_difference.h"

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

namespace aucast::test {

void expect_as_baseline(const view::Image& image, const std::string& name, int tolerance,
                        double share_max) {
  const auto baseline = std::filesystem::path(AUCAST_GOLDEN_SOURCE) / "baselines" / (name + ".png");
  if (std::getenv("AUCAST_UPDATE_GOLDEN") != nullptr) {
    const auto written = view::write_png(image, baseline);
    ASSERT_TRUE(written.has_value()) << written.error().message;
    return;
  }
  const auto wanted = view::read_png(baseline);
  ASSERT_TRUE(wanted.has_value()) << wanted.error().message
                                  << "\nMake it with scripts/update_golden.sh and look at it.";
  const auto difference = compare(image, *wanted, tolerance);
  if (difference.share <= share_max) return;
  const auto result = std::filesystem::path(AUCAST_GOLDEN_RESULTS) / (name + ".png");
  const auto written = view::write_png(image, result);
  ADD_FAILURE() << name << ": " << 100 * difference.share << " % of the pixels differ, at most by "
                << difference.largest << ". Compare " << baseline << " with "
                << (written.has_value() ? result.string() : written.error().message)
                << "; if the change is meant, run scripts/update_golden.sh.";
}

}  // namespace aucast::test
