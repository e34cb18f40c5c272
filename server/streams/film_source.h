#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "common/camera/film_reader.h"
#include "common/result.h"
#include "common/sources/conditioning.h"
#include "server/settings/source_options.h"

namespace aucast::server {

/// A film as a source: the table of what is seen in it, which is read as any recogniser's.
[[nodiscard]] Result<std::string> film_text(
    const std::filesystem::path& path, const SourceOptions& options,
    const std::function<void(const camera::FilmProgress&)>& on_progress = {});

/// How faces are read that we see ourselves: --neutral, in measures of the face, auto unless told
/// otherwise; and all of them when --face-id is given.
[[nodiscard]] camera::FaceOptions faces_of(const SourceOptions& options);

/// What is done with the AUs of this source. Of a film or a camera the neutral face was taken off
/// already, by faces_of(): everything but that.
[[nodiscard]] sources::ConditioningSettings conditioning_for(
    const std::filesystem::path& path, sources::ConditioningSettings settings);

}  // namespace aucast::server
