#include "client/app/window/making/own_aus.h"

#include <utility>

#include "client/app/window/making/own_faces.h"
#include "client/face/face_folder.h"
#include "client/gui/model/view_text.h"
#include "client/gui/storage/face_copies.h"
#include "client/gui/storage/user_face.h"
#include "client/gui/texts/texts.h"
#include "common/files.h"

namespace aucast::app {

OwnAus::OwnAus(const Assets& assets, pipeline::AuMapping& mapping)
    : assets_(assets), mapping_(mapping) {
  change_face();
}

void OwnAus::change_face() {
  shipped_.clear();
  const auto faces = writable_own_faces(assets_.data_folder);
  own_ = faces && gui::is_own_face(assets_.face_folder, faces->own);
  const auto take = [this](const face::Face& face, const face::AuRecordings& aus) {
    for (const auto& [number, recording] : aus) {
      shipped_[number] = gui::drive_of(face, recording.activation);
    }
  };
  if (!own_) return take(assets_.face, assets_.face.recordings);
  // A copy has with it how its AUs came.
  if (const auto came = face::load_aus(assets_.face_folder / gui::kOriginalAusFile, assets_.face)) {
    return take(assets_.face, *came);
  }
  const auto origin = gui::shipped_origin(assets_.face_folder, faces->shipped);
  if (origin.empty()) return;
  if (const auto face = face::load_face(origin, assets_.data_folder)) take(*face, face->recordings);
}

bool OwnAus::differs_from_shipped(int number) const {
  const auto recording = mapping_.recordings.find(number);
  if (!own_ || recording == mapping_.recordings.end()) return false;
  const auto shipped = shipped_.find(number);
  return shipped == shipped_.end() ||
         shipped->second != gui::drive_of(mapping_.face, recording->second.activation);
}

std::vector<gui::AuEntry> OwnAus::entries() const {
  std::vector<gui::AuEntry> entries;
  for (const auto& [number, recording] : mapping_.recordings) {
    if (number == 0) continue;
    gui::AuEntry entry;
    entry.number = number;
    entry.name = gui::saved_au_name(number, mapping_.recordings);
    entry.muscles = gui::drive_in_words(gui::drive_of(mapping_.face, recording.activation));
    const auto looks = assets_.au_looks.find(number);
    if (looks != assets_.au_looks.end()) entry.looks = looks->second;
    entry.own = differs_from_shipped(number);
    entry.shipped = shipped(number);
    entries.push_back(std::move(entry));
  }
  return entries;
}

Result<std::filesystem::path> OwnAus::save(int number, const std::vector<float>& activations,
                                           const std::string& name) {
  face::AuRecording recording;
  recording.number = number;
  recording.activation = activations;
  recording.note = name;
  return take({{number, std::move(recording)}});
}

Result<std::filesystem::path> OwnAus::take(const face::AuRecordings& recordings) {
  const auto faces = writable_own_faces(assets_.data_folder);
  if (!faces) return faces.error();
  auto folder = gui::writable_face(assets_.face_folder, *faces);
  if (!folder) return folder.error();
  std::vector<gui::SavedAu> aus;
  for (const auto& [number, recording] : recordings) {
    aus.push_back({number, gui::drive_of(mapping_.face, recording.activation), recording.note});
  }
  auto file = gui::save_aus(*folder, aus);
  if (!file) return file.error();
  for (const auto& [number, taken] : recordings) {
    face::AuRecording& recording = mapping_.recordings[number];
    recording.number = number;
    recording.activation = taken.activation;
    if (!taken.note.empty()) recording.note = taken.note;
  }
  return file;
}

Result<void> OwnAus::remove(int number) {
  const auto shipped = shipped_.find(number);
  const bool came_so = shipped != shipped_.end();
  auto file = came_so ? gui::save_aus(assets_.face_folder, {{number, shipped->second, {}}})
                      : gui::remove_au(assets_.face_folder, number);
  if (!file) return file.error();
  if (!came_so) {
    mapping_.recordings.erase(number);
    return {};
  }
  // As the file has it now.
  auto face = face::load_face(assets_.face_folder, assets_.data_folder);
  if (!face) return face.error();
  mapping_.recordings[number] = std::move(face->recordings[number]);
  return {};
}

Result<std::string> OwnAus::export_to(int number, const std::filesystem::path& file) const {
  const auto recording = mapping_.recordings.find(number);
  if (recording == mapping_.recordings.end()) {
    return Error{ErrorKind::Usage, gui::tr("said.au_without", number)};
  }
  const gui::Drive drive = gui::drive_of(mapping_.face, recording->second.activation);
  const auto written =
      write_file_atomically(file, gui::aus_text(number, drive, recording->second.note));
  if (!written) return written.error();
  return gui::tr("said.au_exported", number, file.string());
}

}  // namespace aucast::app
