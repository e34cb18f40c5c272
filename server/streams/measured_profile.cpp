#include "server/streams/measured_profile.h"

#include <algorithm>
#include <optional>
#include <string>

namespace aucast::server {

Result<void> save_measured_profile(const SignalOptions& options,
                                   const sources::ConditioningSettings& conditioning,
                                   const std::vector<Source>& sources) {
  if (options.save_profile.empty()) return {};
  if (!measures_neutral(options)) {
    return save_profile(options.save_profile, conditioning, std::nullopt);
  }
  const auto is_measured = [](const Source& source) { return source.found || source.live; };
  const auto measured = std::find_if(sources.begin(), sources.end(), is_measured);
  const auto count = std::count_if(sources.begin(), sources.end(), is_measured);
  if (count != 1) {
    return usage_error(
        "--save-profile with --neutral takes one source of a recogniser, and there are " +
        std::to_string(count));
  }
  if (measured->live) return {};
  return save_profile(options.save_profile, conditioning, measured->found->neutral);
}

}  // namespace aucast::server
