#include "client/app/files_read.h"

#include <string>
#include <system_error>

#include "client/app/assets.h"
#include "client/face/face_folder.h"
#include "common/files.h"
#include "common/overwriting.h"
#include "common/sound_name.h"
#include "common/text.h"
#include "common/toml_document.h"

namespace aucast::app {
namespace {

using Paths = std::vector<std::filesystem::path>;

/// Adds what may be data. Other files of a folder may be what was made of a face.
void add_folder(const std::filesystem::path& folder, Paths& files) {
  std::error_code none;
  for (std::filesystem::directory_iterator at(folder, none), end; at != end; at.increment(none)) {
    const std::string ending = file_ending(at->path());
    if (ending == ".toml" || ending == ".ply" || ending == ".dat") files.push_back(at->path());
  }
}

/// A stream file or table, and what belongs to it.
void add_stream(const std::filesystem::path& stream, Paths& files) {
  if (stream.empty()) return;
  files.push_back(stream);
  if (auto sound = sound_beside(stream)) files.push_back(*std::move(sound));
  files.push_back(std::filesystem::path(stream).replace_extension(".vtt"));
}

/// A face may have files of other faces.
void add_face(const std::filesystem::path& folder, Paths& files) {
  add_folder(folder, files);
  const auto face = read_toml(folder / face::kFaceFile);
  if (!face) return;
  for (const char* key : {"mesh", "muscles", "aus"}) {
    const TomlValue* const file = face->find(key);
    if (file != nullptr && !file->text.empty()) files.push_back(folder / file->text);
  }
}

/// Whether FrameFolder may write a picture to `file`.
bool is_frame_of(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code none;
  const std::string name = file.filename().string();
  return !folder.empty() && name.starts_with("frame_") && name.ends_with(".png") &&
         std::filesystem::weakly_canonical(whole_path(folder / name), none) ==
             std::filesystem::weakly_canonical(whole_path(file), none);
}

}  // namespace

std::vector<std::filesystem::path> files_read(const PlayerOptions& options) {
  const net::SecurityOptions& security = options.playback.security;
  Paths files{options.face.rules,         security.token,
              security.files.certificate, security.files.key,
              security.files.authorities, options.mirror.token,
              options.mirror.certificate, options.mirror.key};
  add_stream(options.playback.file, files);
  add_stream(options.exported.stream(), files);
  const auto data = find_data_folder(options.face.data);
  if (!data) return files;
  add_folder(*data, files);
  add_folder(*data / "faces", files);
  add_folder(*data / "languages", files);
  add_folder(*data / "rules", files);
  add_face(face_folder(options.face, *data), files);
  return files;
}

Result<void> check_outputs(const PlayerOptions& options) {
  Paths outputs{options.output.record, options.output.sheet, options.output.stats,
                options.output.onsets, options.sound.file,   options.pose.png,
                options.pose.obj};
  if (options.command == Command::Export) outputs.push_back(options.exported.glb());
  // Most windows write nothing: they need not look for what they read.
  std::erase_if(outputs, [](const auto& output) { return output.empty(); });
  if (outputs.empty()) return {};
  if (auto good = check_distinct(outputs); !good) return good;
  for (const auto& output : outputs) {
    if (!is_frame_of(options.output.frames, output)) continue;
    return Error{
        ErrorKind::Usage,
        printable(output.string()) + " has the name of a picture of --frames; choose another one"};
  }
  return check_not_read(outputs, files_read(options));
}

Result<void> check_last_outputs(const OutputOptions& output) {
  for (const auto& file : {output.stats, output.sheet}) {
    if (file.empty()) continue;
    if (auto writable = check_writable(file); !writable) return writable;
  }
  return {};
}

}  // namespace aucast::app
