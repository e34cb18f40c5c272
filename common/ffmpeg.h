#pragma once

#include <filesystem>
#include <string>

#include "common/result.h"
#include "common/text.h"

namespace aucast {

/// The program that decodes films and cameras and writes videos, looked up in $PATH.
inline constexpr const char* kFfmpeg = "ffmpeg";

/// What ffmpeg calls a file. Without "file:" a name with a colon would be a network address.
[[nodiscard]] inline std::string ffmpeg_name(const std::filesystem::path& file) {
  return "file:" + file.string();
}

/// The error for an ffmpeg that could not be started; `error` is what Child::start() said. `place`:
/// of the message; `task`: what ffmpeg does, "writes the video".
[[nodiscard]] inline Error ffmpeg_not_started(const Error& error, const std::string& place,
                                              const std::string& task) {
  if (error.kind != ErrorKind::Unreadable) return error;
  return {ErrorKind::Failed,
          at_place(place, "ffmpeg, which " + task + ", is not installed: apt install ffmpeg")};
}

}  // namespace aucast
