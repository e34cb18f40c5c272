#include "server/live/recorder.h"

#include <array>
#include <chrono>
#include <ctime>
#include <system_error>
#include <utility>
#include <vector>

#include "common/log.h"
#include "common/text.h"
#include "protocol/stream_file.h"

namespace aucast::server {
namespace {

/// The serial number in every Ogg file, always the same, so that equal recordings are equal files.
constexpr std::uint32_t kOggSerial = 1;

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::start(const std::filesystem::path& path) {
  auto face = RecordWriter::start(path, kStreamFileForm);
  if (!face) return face.error();
  return std::make_unique<Recorder>(path, std::move(*face));
}

Recorder::Recorder(std::filesystem::path path, std::unique_ptr<RecordWriter> face)
    : path_(std::move(path)), face_(std::move(face)), pages_(Milliseconds::zero(), kOggSerial) {}

Recorder::~Recorder() {
  static_cast<void>(finish());
}

Result<void> Recorder::add_voice_file() {
  auto voice = RecordWriter::start(voice_record_path(path_), kPagesForm);
  if (!voice) return voice.error();
  voice_ = std::move(*voice);
  return {};
}

void Recorder::add(const protocol::Keyframe& keyframe, SteadyTime now, bool free) {
  std::vector<std::string> lines;
  for (const protocol::Keyframe& line : timeline_.add(keyframe, now, free)) {
    lines.push_back(protocol::format_stream_line(line) + '\n');
    end_ += Milliseconds(line.time_ms.value_or(0));
  }
  face_->add(std::move(lines));
}

void Recorder::add_voice(protocol::VoicePacket packet, Milliseconds after) {
  if (!voice_) return;
  packet.place = end_ + after;
  const std::size_t bytes = sizeof(packet) + packet.opus.size();
  voice_->add(bytes, [this, packet = std::move(packet)] {
    return pages_.add(packet) ? pages_.take() : std::string();
  });
}

Result<void> Recorder::finish() {
  const bool first_time = !std::exchange(finished_, true);
  const auto face = face_->finish();
  if (first_time)
    spdlog::info("{} recorded to {}", counted(face_->written(), "keyframe"), path_.string());
  if (!voice_) return face;
  if (first_time) {
    voice_->add(0,
                [this, end = end_] { return pages_.any() ? pages_.finish(end) : std::string(); });
  }
  const auto voice = voice_->finish();
  return face ? voice : face;
}

std::filesystem::path voice_record_path(std::filesystem::path record) {
  return record.replace_extension(".opus");
}

std::optional<std::filesystem::path> record_path(const std::filesystem::path& record,
                                                 const std::string& stream, bool first) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(record, ignored)) {
    return first ? std::optional(record) : std::nullopt;
  }
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> time{};
  const std::size_t length = std::strftime(time.data(), time.size(), "-%Y%m%dT%H%M%SZ", &parts);
  const std::string name = stream + std::string(time.data(), length);
  std::filesystem::path path = record / (name + ".txt");
  for (int count = 2; exists(path, ignored) || exists(voice_record_path(path), ignored); ++count) {
    path = record / (name + "-" + std::to_string(count) + ".txt");
  }
  return path;
}

}  // namespace aucast::server
