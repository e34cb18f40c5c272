#include "client/app/commands/export_command.h"

#include <cstdio>

#include "client/app/assets.h"
#include "client/app/stream_files.h"
#include "client/app/video/glb_export.h"
#include "common/sound_name.h"

namespace aucast::app {
namespace {

Result<ExportedStream> read_exported(const PlayerOptions& options) {
  ExportedStream stream;
  const std::filesystem::path file = options.exported.stream();
  if (file.empty()) return stream;
  auto keyframes = open_typed_stream(file, options.table);
  if (!keyframes) return keyframes.error();
  if (auto fits = check_length(*keyframes, options, file.string()); !fits) return fits.error();
  stream.keyframes = *std::move(keyframes);
  stream.name = file.stem().string();
  if (const auto sound = sound_beside(file)) stream.sound = sound->filename().string();
  return stream;
}

}  // namespace

Result<void> run_export(const PlayerOptions& options) {
  const auto stream = read_exported(options);
  if (!stream) return stream.error();
  const auto assets = load_assets(options.face);
  if (!assets) return assets.error();
  const auto exported = export_glb(**assets, options, *stream);
  if (!exported) return exported.error();
  if (!options.quiet) std::printf("%s\n", exported->c_str());
  return {};
}

}  // namespace aucast::app
