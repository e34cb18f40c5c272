#include <utility>
#include <variant>

#include "client/app/steady.h"
#include "client/app/window/window_session.h"
#include "client/playback/file_source.h"

// The part of the session that plays streams which are there whole, and asks for their files.

namespace aucast::app {
namespace {

constexpr Milliseconds kUntimed{250};
constexpr Milliseconds kNoticeTime{6'000};
constexpr Milliseconds kBadNoticeTime{20'000};

}  // namespace

bool WindowSession::over() const {
  if (source_ == nullptr) return false;
  return local_ ? local_->over() : controller_.over();
}

void WindowSession::advance_local(Instant now) {
  const std::uint64_t played = local_->playback().keyframes_played(now);
  if (local_->advance(now)) {
    local_->begin(*pipeline_);
    explain(pipeline_->received());
    if (!first_begin_) first_begin_ = now;
  }
  if (std::exchange(local_played_, played) != played) {
    stats_.playback_seconds = seconds(now - *first_begin_);
  }
}

void WindowSession::play_local(std::string name, const std::vector<playback::TimedAus>& keyframes) {
  local_.emplace(std::move(name), keyframes, options_.playback.speed.value_or(kUntimed));
}

void WindowSession::carry_out(const gui::LocalCommand& command, Instant now) {
  if (!local_) return;
  local_->apply(command, now);
  const bool changes_the_place = std::holds_alternative<gui::Seek>(command) ||
                                 std::holds_alternative<gui::StepKeyframe>(command) ||
                                 std::holds_alternative<gui::StepFrame>(command);
  if (changes_the_place) shown_ = Shown::Playback;
}

void WindowSession::carry_out(const gui::OpenStream& command, Instant now) {
  const std::filesystem::path file = command.file;
  auto keyframes = read_stream(file);
  if (!keyframes) {
    if (browser_.view().open) {
      browser_.refuse(keyframes.error().message);
    } else {
      say(keyframes.error().message, true, now);
    }
    return;
  }
  browser_.close();
  notice_ = {};
  last_folder_ = file.parent_path();
  replace_source(std::make_unique<playback::FileSource>(*keyframes), options_.playback.speed, now);
  play_local(file.filename().string(), *keyframes);
}

void WindowSession::carry_out(const gui::Browse& command, Instant) {
  const bool saving = gui::is_saving(command.purpose);
  std::string name;
  if (saving) name = std::filesystem::path(composer_.file()).filename().string();
  if (command.purpose == gui::Purpose::ExportKeyframes) name = "exported.txt";
  browser_.open(command.purpose, saving ? own_folder() : last_folder_, name);
}

void WindowSession::carry_out(const gui::EnterFolder& command, Instant) {
  browser_.enter(command.folder);
}

void WindowSession::carry_out(const gui::ChooseFile& command, Instant now) {
  std::filesystem::path file;
  if (!browser_.view().open || !browser_.choose(command.file, file)) return;
  switch (browser_.view().purpose) {
    case gui::Purpose::PlayStream:
      return carry_out(gui::OpenStream{file.string()}, now);
    case gui::Purpose::ComposeStream:
      return load_composition(file, now);
    case gui::Purpose::SaveStream:
      return save_composition(file, now);
    case gui::Purpose::ExportKeyframes:
      return export_keyframes(file, now);
  }
}

void WindowSession::carry_out(const gui::CloseBrowser&, Instant) {
  browser_.close();
}

void WindowSession::carry_out(const gui::CloseNotice&, Instant) {
  notice_ = {};
}

void WindowSession::say(std::string text, bool bad, Instant now) {
  notice_ = {std::move(text), bad};
  notice_until_ = now + (bad ? kBadNoticeTime : kNoticeTime);
}

}  // namespace aucast::app
