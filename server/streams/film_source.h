#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "common/camera/film_reader.h"
#include "common/result.h"
#include "common/sources/conditioning.h"
#include "server/settings/signal_options.h"

namespace aucast::server {

/// A film as a source: the table of what is seen in it, which is read as any recogniser's.
[[nodiscard]] Result<std::string> film_text(
    const std::filesystem::path& path, const SignalOptions& options,
    const std::function<void(const camera::FilmProgress&)>& on_progress = {});

/// What is taken off a face that we have seen ourselves: --neutral, in measures of the face. Auto
/// unless told otherwise.
[[nodiscard]] camera::QuietOptions quiet_of(const SignalOptions& options);

/// What is done with the AUs of this source. Of a film or a camera the neutral face was taken off
/// already, by quiet_of(): everything but that.
[[nodiscard]] sources::ConditioningSettings conditioning_for(
    const std::filesystem::path& path, sources::ConditioningSettings settings);

}  // namespace aucast::server
