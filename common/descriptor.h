#pragma once

#include <unistd.h>

#include <system_error>
#include <utility>

namespace aucast {

/// A file descriptor that closes itself; a negative value means none.
class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  /// Swaps the two descriptors, so what this one had open is closed when `other` is destroyed.
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] bool open() const { return value_ >= 0; }
  [[nodiscard]] int get() const { return value_; }
  [[nodiscard]] int release() { return std::exchange(value_, -1); }
  /// Hands the descriptor over to an object of Asio, such as a stream_descriptor, which closes it
  /// from then on. Returns false and keeps the descriptor if the object cannot take it.
  template <typename Object>
  [[nodiscard]] bool hand_to(Object& object) {
    std::error_code error;
    object.assign(value_, error);
    if (!error) value_ = -1;
    return !error;
  }
  /// Closes now and returns whether that worked: some file systems report a full disk only then.
  [[nodiscard]] bool close() { return ::close(std::exchange(value_, -1)) == 0; }

 private:
  int value_ = -1;
};

}  // namespace aucast
