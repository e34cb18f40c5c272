#include "client/app/window/export_session.h"

#include <utility>

#include "client/app/film/obj_writer.h"
#include "client/app/window/au_table.h"
#include "client/app/window/composition_file.h"
#include "client/face/face_deformer.h"
#include "client/gui/texts.h"
#include "common/files.h"
#include "protocol/limits.h"

namespace aucast::app {
namespace {

std::string exported(std::string sentence, std::size_t kept, std::uint64_t all) {
  return kept < all ? gui::tr("said.exported_first", sentence, kept, all) : sentence;
}

Error nothing_played() {
  return {ErrorKind::Failed, gui::tr("said.nothing_played")};
}

}  // namespace

Result<std::string> ExportSession::stream(const Played& played, const std::filesystem::path& file) {
  if (played.keyframes.empty()) return nothing_played();
  gui::Composer::Keyframes keyframes;
  for (const playback::TimedAus& one : played.keyframes) {
    keyframes.push_back(std::make_shared<const gui::ComposedKeyframe>(composed(one)));
  }
  const auto saved = save_stream(keyframes, file);
  if (!saved) return saved;
  return exported(gui::tr("said.exported_stream", gui::keyframes_text(keyframes.size()), *saved),
                  keyframes.size(), played.begun);
}

Result<std::string> ExportSession::table(const Played& played, const std::filesystem::path& file) {
  const std::size_t count = played.keyframes.size();
  if (count == 0) return nothing_played();
  const auto written = write_file_atomically(
      file, format_au_table(played.keyframes, protocol::kDefaultKeyframeTime));
  if (!written) return written.error();
  return exported(gui::tr("said.exported_table", gui::keyframes_text(count), file.string()), count,
                  played.begun);
}

Result<std::string> ExportSession::mesh(const face::Face& face, std::span<const float> activations,
                                        const std::filesystem::path& file) {
  face::FaceDeformer deformer(face);
  const auto written =
      write_file_atomically(file, format_obj(face.mesh, deformer.deform(activations).positions));
  if (!written) return written.error();
  return gui::tr("said.exported_mesh", file.string());
}

Result<std::string> ExportSession::glb(PlayerOptions options, Played played,
                                       const std::string& name, const std::filesystem::path& file) {
  if (work_.running()) return Error{ErrorKind::Failed, gui::tr("said.glb_before")};
  options.exported.files = {file};
  const auto begun =
      work_.begin([make = make_, options = std::move(options), played = std::move(played),
                   name](BackgroundWork::Course&) -> Result<std::string> {
        auto made = make(options, played.keyframes, name);
        if (!made) return made;
        return exported(*std::move(made), played.keyframes.size(), played.begun);
      });
  if (!begun) return begun.error();
  return gui::tr("said.glb_writing", file.string());
}

}  // namespace aucast::app
