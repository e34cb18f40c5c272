#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "common/check.h"

namespace aucast {

/// The kinds of failure that callers treat differently. The values are the exit codes of all
/// programs.
enum class ErrorKind : std::uint8_t {
  Failed = 1,      ///< failed while running: graphics, unwritable output, ffmpeg missing
  Usage = 2,       ///< the command line asks for something that does not exist
  BadData = 3,     ///< a file was read and is wrong; the message names file:line:column
  Unreadable = 4,  ///< a file is missing or cannot be read
  Network = 5,  ///< a peer cannot be reached, is silent, is lost, refuses or breaks the protocol;
                ///< or the program cannot listen
};

/// A failure as a value: its kind, and a sentence for the user that names the place, the cause and,
/// where there is one, the remedy.
struct Error {
  ErrorKind kind = ErrorKind::Failed;
  std::string message;
  friend bool operator==(const Error&, const Error&) = default;
};

[[nodiscard]] inline int exit_code(const Error& error) {
  return static_cast<int>(error.kind);
}

/// A value or an Error, with the member names of C++23's std::expected (absent in GCC 12).
/// Asking for the value of a failure, or for the error of a success, is a programming error and
/// aborts.
template <typename T>
class [[nodiscard]] Result {
 public:
  using value_type = T;

  // Implicit on purpose: `return value;` and `return Error{...};` both read well.
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool has_value() const noexcept { return state_.index() == 0; }
  [[nodiscard]] explicit operator bool() const noexcept { return has_value(); }

  [[nodiscard]] T& value() & { return checked(); }
  [[nodiscard]] const T& value() const& {
    AUCAST_CHECK(has_value());
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] T&& value() && { return std::move(checked()); }
  [[nodiscard]] T& operator*() & { return value(); }
  [[nodiscard]] const T& operator*() const& { return value(); }
  [[nodiscard]] T&& operator*() && { return std::move(checked()); }
  [[nodiscard]] T* operator->() { return &value(); }
  [[nodiscard]] const T* operator->() const { return &value(); }

  [[nodiscard]] const Error& error() const {
    AUCAST_CHECK(!has_value());
    return *std::get_if<1>(&state_);
  }

 private:
  T& checked() {
    AUCAST_CHECK(has_value());
    return *std::get_if<0>(&state_);
  }

  std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  using value_type = void;

  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  [[nodiscard]] bool has_value() const noexcept { return !error_.has_value(); }
  [[nodiscard]] explicit operator bool() const noexcept { return has_value(); }
  [[nodiscard]] const Error& error() const {
    AUCAST_CHECK(!has_value());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace aucast
