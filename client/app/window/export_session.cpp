#include "client/app/window/export_session.h"

#include <utility>

#include "client/app/film/obj_writer.h"
#include "client/app/window/au_table.h"
#include "client/face/face_deformer.h"
#include "common/files.h"
#include "common/text.h"
#include "protocol/limits.h"

namespace aucast::app {

Result<std::string> ExportSession::table(std::span<const playback::TimedAus> keyframes,
                                         const std::filesystem::path& file) {
  if (keyframes.empty()) {
    return Error{ErrorKind::Failed, "nothing has been played that could be exported"};
  }
  const auto written =
      write_file_atomically(file, format_au_table(keyframes, protocol::kDefaultKeyframeTime));
  if (!written) return written.error();
  return counted(keyframes.size(), "keyframe") + " as a table in " + file.string();
}

Result<std::string> ExportSession::mesh(const face::Face& face, std::span<const float> activations,
                                        const std::filesystem::path& file) {
  face::FaceDeformer deformer(face);
  const auto written =
      write_file_atomically(file, format_obj(face.mesh, deformer.deform(activations).positions));
  if (!written) return written.error();
  return "this face as a mesh in " + file.string();
}

Result<std::string> ExportSession::glb(PlayerOptions options,
                                       std::vector<playback::TimedAus> keyframes,
                                       const std::string& name, const std::filesystem::path& file) {
  if (work_.running())
    return Error{ErrorKind::Failed, "the GLB file before is still being written"};
  options.exported.files = {file};
  const auto begun =
      work_.begin([make = make_, options = std::move(options), keyframes = std::move(keyframes),
                   name](BackgroundWork::Course&) { return make(options, keyframes, name); });
  if (!begun) return begun.error();
  return "writing " + file.string() + " ...";
}

}  // namespace aucast::app
