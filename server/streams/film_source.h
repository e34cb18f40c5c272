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

/// Reads the faces in a film. Returns their table, which is then read like any recogniser's.
[[nodiscard]] Result<std::string> film_text(
    const std::filesystem::path& path, const SourceOptions& options,
    const std::function<void(const camera::FilmProgress&)>& on_progress = {},
    const std::stop_token& stop = {});

/// How faces are read in pictures. With these options the neutral face of --neutral (by default
/// `auto`) is subtracted from a face's measures, before AUs are made of them. All faces are read if
/// --face-id is given.
[[nodiscard]] camera::FaceOptions faces_of(const SourceOptions& options);

/// How the AUs of this source are conditioned. For a film or a camera, without the neutral face,
/// which has already been subtracted (faces_of()).
[[nodiscard]] sources::ConditioningSettings conditioning_for(
    const std::filesystem::path& path, sources::ConditioningSettings settings);

}  // namespace aucast::server
