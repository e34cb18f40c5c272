#include "client/app/window/files/export_session.h"

#include <utility>

#include "client/app/video/obj_writer.h"
#include "client/app/window/files/au_table.h"
#include "client/app/window/making/composition_file.h"
#include "client/face/face_deformer.h"
#include "client/gui/texts/texts.h"
#include "common/files.h"

namespace aucast::app {
namespace {

/// A second line if keyframes are missing.
std::string missing(const Played& played) {
  const std::size_t kept = played.keyframes.size();
  return kept == played.begun ? "" : "\n" + gui::tr("said.exported_first", kept, played.begun);
}

Error nothing_played() {
  return {ErrorKind::Failed, gui::tr("said.nothing_played")};
}

}  // namespace

Result<std::string> ExportSession::stream(const Played& played, const std::filesystem::path& file) {
  if (played.keyframes.empty()) return nothing_played();
  gui::Composer::Keyframes keyframes;
  for (const playback::Keyframe& one : played.keyframes) {
    keyframes.push_back(std::make_shared<const gui::ComposedKeyframe>(composed(one)));
  }
  const auto saved = save_stream(keyframes, file);
  if (!saved) return saved;
  return gui::tr("said.exported_stream", gui::keyframes_text(keyframes.size()), *saved) +
         missing(played);
}

Result<std::string> ExportSession::table(const Played& played, const std::filesystem::path& file) {
  const std::size_t count = played.keyframes.size();
  if (count == 0) return nothing_played();
  const auto written =
      write_file_atomically(file, format_au_table(played.keyframes, played.untimed));
  if (!written) return written.error();
  return gui::tr("said.exported_table", gui::keyframes_text(count), file.string()) +
         missing(played);
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
  // The texts are taken now: the thread must not read them while the language changes.
  const auto begun =
      work_.begin([make = make_, options = std::move(options), missing = missing(played),
                   keyframes = std::move(played.keyframes), name](BackgroundWork::Course& course) {
        auto made = make(options, keyframes, name, course);
        return made ? Result<std::string>(*made + missing) : made;
      });
  if (!begun) return begun.error();
  file_ = file.string();
  return gui::tr("said.writing", file_);
}

std::optional<Result<std::string>> ExportSession::advance() {
  auto outcome = work_.take_outcome();
  if (outcome && !*outcome && work_.cancelled()) return gui::tr("said.glb_cancelled", file_);
  return outcome;
}

gui::ExportView ExportSession::view() const {
  if (!work_.running()) return {};
  const auto [done, total] = work_.reached();
  return {file_, total == 0 ? 0 : static_cast<int>(100 * done / total), work_.cancelled()};
}

}  // namespace aucast::app
