#include "client/app/window/export_session.h"

#include <utility>

#include "client/app/film/obj_writer.h"
#include "client/app/window/au_table.h"
#include "client/face/face_deformer.h"
#include "client/gui/texts.h"
#include "common/files.h"
#include "protocol/limits.h"

namespace aucast::app {

Result<std::string> ExportSession::table(std::span<const playback::TimedAus> keyframes,
                                         const std::filesystem::path& file) {
  if (keyframes.empty()) {
    return Error{ErrorKind::Failed, gui::tr("said.nothing_played")};
  }
  const auto written =
      write_file_atomically(file, format_au_table(keyframes, protocol::kDefaultKeyframeTime));
  if (!written) return written.error();
  return gui::tr("said.exported_table", gui::keyframes_text(keyframes.size()), file.string());
}

Result<std::string> ExportSession::mesh(const face::Face& face, std::span<const float> activations,
                                        const std::filesystem::path& file) {
  face::FaceDeformer deformer(face);
  const auto written =
      write_file_atomically(file, format_obj(face.mesh, deformer.deform(activations).positions));
  if (!written) return written.error();
  return gui::tr("said.exported_mesh", file.string());
}

Result<std::string> ExportSession::glb(PlayerOptions options,
                                       std::vector<playback::TimedAus> keyframes,
                                       const std::string& name, const std::filesystem::path& file) {
  if (work_.running()) return Error{ErrorKind::Failed, gui::tr("said.glb_before")};
  options.exported.files = {file};
  const auto begun =
      work_.begin([make = make_, options = std::move(options), keyframes = std::move(keyframes),
                   name](BackgroundWork::Course&) { return make(options, keyframes, name); });
  if (!begun) return begun.error();
  return gui::tr("said.glb_writing", file.string());
}

}  // namespace aucast::app
