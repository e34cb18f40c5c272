#include "server/streams/film_source.h"

#include <utility>

#include "common/film_name.h"
#include "common/log.h"
#include "server/streams/source_path.h"

namespace aucast::server {

Result<std::string> film_text(const std::filesystem::path& path, const SourceOptions& options,
                              const std::function<void(const camera::FilmProgress&)>& on_progress,
                              const std::stop_token& stop) {
  auto table = camera::read_film(path, faces_of(options), on_progress, stop);
  if (!table) return table.error();
  if (!table->note.empty()) spdlog::warn("{}", table->note);
  return std::move(table->text);
}

camera::FaceOptions faces_of(const SourceOptions& options) {
  return {options.signal.neutral_auto ? std::nullopt : options.signal.neutral_seconds,
          options.recording.face.has_value() || options.recording.all_faces};
}

sources::ConditioningSettings conditioning_for(const std::filesystem::path& path,
                                               sources::ConditioningSettings settings) {
  if (!is_film(path) && !camera_device(path)) return settings;
  settings.neutral_seconds.reset();
  settings.neutral_turns_only = false;
  return settings;
}

}  // namespace aucast::server
