#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "common/camera/film_reader.h"
#include "common/result.h"
#include "common/sources/conditioning.h"
#include "server/settings/source_options.h"

namespace aucast::server {

/// A film as a source: the table of what is seen in it, which is read like any recogniser's.
[[nodiscard]] Result<std::string> film_text(
    const std::filesystem::path& path, const SourceOptions& options,
    const std::function<void(const camera::FilmProgress&)>& on_progress = {},
    const std::stop_token& stop = {});

/// How we read faces in pictures: with --neutral, which is auto by default and applies to the
/// measures of the face; and all faces when --face-id is given.
[[nodiscard]] camera::FaceOptions faces_of(const SourceOptions& options);

/// How the AUs of this source are conditioned. For a film or a camera that leaves out the neutral
/// face, which faces_of() has already subtracted.
[[nodiscard]] sources::ConditioningSettings conditioning_for(
    const std::filesystem::path& path, sources::ConditioningSettings settings);

}  // namespace aucast::server
