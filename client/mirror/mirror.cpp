#include "client/mirror/mirror.h"

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "common/files.h"
#include "common/overloaded.h"
#include "common/text.h"

namespace aucast::mirror {
namespace {

constexpr const char* kProgram = "au-transmitter";
constexpr std::size_t kChunkBytes = 65'536;

std::string find_program(const std::filesystem::path& chosen) {
  if (!chosen.empty()) return chosen.string();
  std::error_code ignored;
  const auto folder = program_folder();
  if (folder && std::filesystem::exists(*folder / kProgram, ignored)) {
    return (*folder / kProgram).string();
  }
  return kProgram;
}

/// What au-transmitter calls a camera.
std::string camera_of(const std::string& source) {
  if (source.empty()) return "camera";
  if (source == "camera" || source.starts_with("camera:")) return source;
  return "camera:" + source;
}

/// An entry of the log without its time and program.
std::string without_head(const std::string& line) {
  const std::string head = std::string(kProgram) + ": ";
  const std::size_t at = line.find(head);
  return at == std::string::npos ? line : line.substr(at + head.size());
}

/// A sentence. A program that was killed had no time for last words.
std::string why_ended(int exit_code, const std::string& last_line) {
  constexpr int kSignalled = 128;
  // Our own, as it had ended its output.
  if (exit_code > kSignalled && exit_code != kSignalled + SIGKILL) {
    return std::string(kProgram) + " was ended by signal " + std::to_string(exit_code - kSignalled);
  }
  std::string why = without_head(last_line);
  return why.empty() ? std::string(kProgram) + " has ended" : why;
}

}  // namespace

Result<std::unique_ptr<Mirror>> Mirror::start(const MirrorOptions& options) {
  const std::string program = find_program(options.program);
  bool missing = false;
  auto child = Child::start({program, "--preview", "--config", "/dev/null", "--bind", "127.0.0.1",
                             "--port", "0", "--log-level", "warning", camera_of(options.source)},
                            missing, Child::Flow::Both);
  if (!child && missing) {
    return Error{ErrorKind::Failed, std::string(kProgram) +
                                        ", which opens the camera, is not installed: it belongs "
                                        "beside face-player or in a folder of PATH"};
  }
  if (!child) return child.error();
  try {
    return std::unique_ptr<Mirror>(new Mirror(std::move(*child)));
  } catch (const std::system_error& failure) {
    return Error{ErrorKind::Failed, shortage_text(failure)};
  }
}

Mirror::Mirror(std::unique_ptr<Child> child)
    : child_(std::move(child)), thread_([this] { read(); }) {}

Mirror::~Mirror() {
  end();
  std::unique_lock lock(mutex_);
  const bool over = changed_.wait_for(lock, kPatience, [this] { return !reading_; });
  if (!over) child_->stop();
}

void Mirror::order(const preview::Order& order) {
  const std::lock_guard lock(mutex_);
  state_.refused.clear();
  if (!reading_ || asked_to_end_) return;
  if (!child_->tell(preview::order_text(order))) {
    state_.refused = std::string(kProgram) + " does not answer";
  }
}

void Mirror::end() {
  const std::lock_guard lock(mutex_);
  if (std::exchange(asked_to_end_, true) || !reading_) return;
  child_->end_input();
}

MirrorState Mirror::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void Mirror::take(preview::Record record) {
  const Overloaded note{
      [this](preview::Listening& one) { state_.address = std::move(one.address); },
      [this](preview::Seen& one) {
        state_.seen = std::make_shared<const preview::Seen>(std::move(one));
      },
      [this](preview::Live& one) { state_.live = std::move(one.address); },
      [this](preview::Private&) { state_.live.clear(); },
      [this](preview::Watching& one) { state_.watching = one.count; },
      [this](preview::Refused& one) { state_.refused = printable(one.sentence); }};
  const std::lock_guard lock(mutex_);
  std::visit(note, record);
}

/// What is wrong with what came, if anything.
std::optional<std::string> Mirror::take_all(preview::PreviewReader& reader) {
  while (true) {
    auto record = reader.next();
    if (!record) return record.error().message;
    if (!*record) return std::nullopt;
    take(std::move(**record));
  }
}

void Mirror::read() {
  preview::PreviewReader reader;
  std::vector<std::uint8_t> chunk(kChunkBytes);
  std::optional<std::string> wrong;
  while (!wrong) {
    const std::size_t got = child_->read(chunk);
    if (got == 0) break;
    reader.feed({reinterpret_cast<const char*>(chunk.data()), got});
    wrong = take_all(reader);
  }
  {
    const std::lock_guard lock(mutex_);
    reading_ = false;
  }
  // It has no more to say; what has ended already keeps its exit code.
  child_->stop();
  const int code = child_->wait();
  const std::string why = wrong ? *wrong : why_ended(code, child_->last_line());
  const std::lock_guard lock(mutex_);
  if (!asked_to_end_) state_.ended = why;
  state_.live.clear();
  state_.watching = 0;
  state_.over = true;
  changed_.notify_all();
}

}  // namespace aucast::mirror
