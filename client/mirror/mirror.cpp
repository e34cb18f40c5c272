#include "client/mirror/mirror.h"

#include <chrono>
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
#include "common/thread.h"

namespace aucast::mirror {
namespace {

constexpr const char* kProgram = "au-transmitter";
constexpr std::size_t kChunkBytes = 65'536;
/// How long after the end of its output a child may take to end.
constexpr Milliseconds kEndTakes{200};

std::string find_program(const std::filesystem::path& chosen) {
  if (!chosen.empty()) return chosen.string();
  std::error_code ignored;
  const auto folder = program_folder();
  if (folder && std::filesystem::exists(*folder / kProgram, ignored)) {
    return (*folder / kProgram).string();
  }
  return kProgram;
}

/// The name of the source for au-transmitter.
std::string camera_of(const std::string& source) {
  if (source.empty()) return "camera";
  if (source == "camera" || source.starts_with("camera:")) return source;
  return "camera:" + source;
}

/// A line of the log without its time and program.
std::string without_head(const std::string& line) {
  const std::string head = std::string(kProgram) + ": ";
  const std::size_t at = line.find(head);
  return at == std::string::npos ? line : line.substr(at + head.size());
}

Trouble said(std::string why) {
  return {Trouble::Kind::Said, std::move(why)};
}

/// Why the child has ended, which we had to kill if not `by_itself`. If a signal ended it, its last
/// line is not the reason.
Trouble why_ended(int exit_code, bool by_itself, const std::string& last_line) {
  constexpr int kSignalled = 128;
  if (exit_code > kSignalled && by_itself) {
    return {Trouble::Kind::Signalled, {}, exit_code - kSignalled};
  }
  if (exit_code == 0) return {Trouble::Kind::NoPictures};
  std::string why = without_head(last_line);
  return why.empty() ? Trouble{Trouble::Kind::Ended} : said(std::move(why));
}

}  // namespace

Result<std::unique_ptr<Mirror>> Mirror::start(const MirrorOptions& options) {
  const std::string program = find_program(options.program);
  std::vector<std::string> command{program,     "--preview", "--config", "/dev/null",   "--bind",
                                   "127.0.0.1", "--port",    "0",        "--log-level", "warning"};
  const auto add_file = [&command](const char* option, const std::filesystem::path& file) {
    if (!file.empty()) command.insert(command.end(), {option, file.string()});
  };
  add_file("--token-file", options.token);
  add_file("--tls-cert", options.certificate);
  add_file("--tls-key", options.key);
  command.push_back(camera_of(options.source));
  auto child = Child::start(command, Child::Flow::Both);
  if (!child && child.error().kind == ErrorKind::Unreadable) {
    return Error{ErrorKind::Unreadable, std::string(kProgram) +
                                            ", which opens the camera, is not installed: it "
                                            "belongs beside face-player or in a folder of PATH"};
  }
  if (!child) return child.error();
  std::unique_ptr<Mirror> mirror(new Mirror(std::move(*child)));
  auto started = start_thread([&mirror = *mirror] { mirror.read(); });
  if (!started) {
    mirror->course_.with([](Course& course) { course.reading = false; });
    return started.error();
  }
  mirror->thread_ = std::move(*started);
  return mirror;
}

Mirror::Mirror(std::unique_ptr<Child> child) : child_(std::move(child)) {}

Mirror::~Mirror() {
  end();
  course_.wait_until(
      std::chrono::steady_clock::now() + kPatience,
      [](const Course& course) { return !course.reading; },
      [this](const Course& course) {
        if (course.reading) child_->stop();
      });
}

void Mirror::order(const preview::Order& order) {
  course_.with([&](Course& course) {
    course.state.refused = {};
    if (!course.reading || course.asked_to_end) return;
    if (!child_->tell(preview::order_text(order))) {
      course.state.refused = {Trouble::Kind::Silent};
    }
  });
}

void Mirror::end() {
  course_.with([this](Course& course) {
    if (std::exchange(course.asked_to_end, true) || !course.reading) return;
    child_->end_input();
  });
}

MirrorState Mirror::state() const {
  return course_.with([](const Course& course) { return course.state; });
}

void Mirror::take(preview::Record record) {
  course_.with([&record](Course& course) {
    MirrorState& state = course.state;
    std::visit(
        Overloaded{[&](preview::Listening& one) { state.own = std::move(one); },
                   [&](preview::Seen& one) {
                     state.seen = std::make_shared<const preview::Seen>(std::move(one));
                   },
                   [&](preview::Live& one) { state.live = std::move(one.address); },
                   [&](preview::Private&) { state.live.clear(); },
                   [&](preview::Watching& one) { state.watching = one.count; },
                   [&](preview::Refused& one) { state.refused = said(printable(one.sentence)); }},
        record);
  });
}

/// Takes all complete records; returns what is wrong with them, if anything is.
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
  course_.change([](Course& course) { course.reading = false; });
  // There is no more output to read. Only what still runs then is killed, so that a SIGKILL of the
  // system's, which is short of memory, is not taken for ours.
  const bool by_itself = !wrong && child_->ends_within(kEndTakes);
  child_->stop();
  const int code = child_->wait();
  const Trouble why = wrong ? said(*wrong) : why_ended(code, by_itself, child_->last_line());
  course_.change([&why](Course& course) {
    if (!course.asked_to_end) course.state.ended = why;
    course.state.live.clear();
    course.state.watching = 0;
    course.state.over = true;
  });
}

}  // namespace aucast::mirror
