#include "server/live/live_input.h"

#include <fcntl.h>
#include <unistd.h>

#include <utility>

#include "common/log.h"
#include "server/live/file_reader.h"
#include "server/live/pipe_reader.h"

namespace aucast::server {

LiveInput::LiveInput(asio::io_context& io, std::filesystem::path path, bool follow, Events events,
                     Opener open)
    : io_(io),
      path_(std::move(path)),
      follow_(follow),
      events_(std::move(events)),
      open_(std::move(open)),
      reader_events_{[this](std::string_view bytes) {
                       failure_.reset();
                       events_.on_bytes(bytes);
                     },
                     [this](Error failure) { note_failure(std::move(failure)); },
                     [this] { on_reader_end(); },
                     [this] {
                       failure_.reset();
                       events_.on_caught_up();
                     },
                     [this](const std::string& why) { events_.on_anew(why); }} {}

Result<Descriptor> LiveInput::open_path() const {
  if (open_) return open_();
  // Of stdin a copy: closing ours must not close it. Not O_NONBLOCK, which whoever shares it with
  // us would get too. No terminal becomes ours, whose hang-up would end us.
  constexpr int kHow = O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY;
  Descriptor descriptor(path_ == "-" ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                                     : ::open(path_.c_str(), kHow));
  if (descriptor.open()) return descriptor;
  return unreadable_now(path_);
}

void LiveInput::note_failure(Error failure) {
  if (!failure_) spdlog::error("{}", failure.message);
  failure_ = std::move(failure);
}

Result<void> LiveInput::start() {
  auto descriptor = open_path();
  if (!descriptor) return descriptor.error();
  read_from(*std::move(descriptor));
  return {};
}

/// Replaces the reader.
void LiveInput::read_from(Descriptor descriptor) {
  if (auto pipe = PipeReader::take(io_, descriptor)) {
    reader_ = std::make_unique<PipeReader>(std::move(*pipe), path_, reader_events_);
  } else {
    reader_ =
        std::make_unique<FileReader>(io_, path_, std::move(descriptor), follow_, reader_events_);
  }
  reader_->set_reading(reading_);
  reader_->start();
}

void LiveInput::set_reading(bool reading) {
  reading_ = reading;
  if (reader_) reader_->set_reading(reading);
}

void LiveInput::stop() {
  if (reader_) reader_->stop();
}

/// A FIFO may get another writer; a pipe does not.
void LiveInput::on_reader_end() {
  const bool again = !reader_->has_past() && path_ != "-" && !open_;
  ended_ = !again;
  if (again) {
    // Opened before the old end is closed: a FIFO that nobody holds forgets what the next writer
    // has already said.
    if (auto descriptor = open_path()) {
      read_from(*std::move(descriptor));
    } else {
      note_failure(descriptor.error());
      ended_ = true;
    }
  }
  if (ended_) reader_->stop();
  events_.on_end();
}

}  // namespace aucast::server
