#include "client/view/video_encoder.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "common/check.h"
#include "common/child.h"
#include "common/ffmpeg.h"
#include "common/temporary_file.h"
#include "common/text.h"

namespace aucast::view {
namespace {

constexpr int kGifFpsMax = 50;  ///< browsers slow down what asks for more
/// After the last picture ffmpeg encodes those that it keeps, dozens of them, and then writes.
constexpr int kEndPatience = 4;

enum class Format : std::uint8_t { Mp4, Webm, Gif };

std::optional<Format> format_of(const std::filesystem::path& path) {
  const std::string ending = file_ending(path);
  if (ending == ".mp4") return Format::Mp4;
  if (ending == ".webm") return Format::Webm;
  if (ending == ".gif") return Format::Gif;
  return std::nullopt;
}

std::vector<std::string> format_arguments(Format format, int fps) {
  // Without this, players guess the colour space from the size, and not all guess alike.
  const std::string colours =
      "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd,format=yuv420p";
  const std::vector<std::string> tags{"-colorspace", "bt709", "-color_primaries", "bt709",
                                      "-color_trc",  "bt709", "-color_range",     "tv"};
  std::vector<std::string> arguments;
  switch (format) {
    case Format::Mp4:
      arguments = {"-vf",  colours, "-c:v",      "libx264",    "-preset", "veryfast",
                   "-crf", "18",    "-movflags", "+faststart", "-f",      "mp4"};
      arguments.insert(arguments.end(), tags.begin(), tags.end());
      break;
    case Format::Webm:
      arguments = {"-vf",     colours, "-c:v",      "libvpx-vp9", "-crf",      "24",
                   "-b:v",    "0",     "-deadline", "good",       "-cpu-used", "4",
                   "-row-mt", "1",     "-f",        "webm"};
      arguments.insert(arguments.end(), tags.begin(), tags.end());
      break;
    case Format::Gif:
      arguments = {"-filter_complex",
                   "[0:v]fps=" + std::to_string(std::min(fps, kGifFpsMax)) +
                       ",split[a][b];[a]palettegen=stats_mode=full[p];"
                       "[b][p]paletteuse=dither=sierra2_4a",
                   "-f", "gif"};
      break;
  }
  return arguments;
}

/// The file to write, the same bytes each time. `flags`: the option with the flags of what is
/// encoded.
void add_output(const std::string& flags, const std::filesystem::path& file,
                std::vector<std::string>& arguments) {
  arguments.insert(arguments.end(),
                   {"-fflags", "+bitexact", flags, "+bitexact", ffmpeg_name(file)});
}

std::vector<std::string> ffmpeg_arguments(Format format, int width, int height, int fps,
                                          const std::filesystem::path& file) {
  // Without -xerror, ffmpeg reports success even if the disk is full at the end.
  std::vector<std::string> arguments{
      kFfmpeg,        "-nostdin",
      "-hide_banner", "-loglevel",
      "error",        "-y",
      "-f",           "rawvideo",
      "-pix_fmt",     "rgba",
      "-s",           std::to_string(width) + "x" + std::to_string(height),
      "-r",           std::to_string(fps),
      "-i",           "pipe:0",
      "-an",          "-xerror"};
  for (std::string& argument : format_arguments(format, fps))
    arguments.push_back(std::move(argument));
  add_output("-flags:v", file, arguments);
  return arguments;
}

/// The command that joins the pictures of one file and the sound of another, which both begin at 0.
std::vector<std::string> muxing_arguments(Format format, const std::filesystem::path& pictures,
                                          const std::filesystem::path& sound,
                                          const std::filesystem::path& file) {
  std::vector<std::string> arguments{kFfmpeg,        "-nostdin",
                                     "-hide_banner", "-loglevel",
                                     "error",        "-y",
                                     "-i",           ffmpeg_name(pictures),
                                     "-i",           ffmpeg_name(sound),
                                     "-map",         "0:v",
                                     "-map",         "1:a",
                                     "-c:v",         "copy",
                                     "-xerror"};
  const std::vector<std::string> coding =
      format == Format::Mp4
          ? std::vector<std::string>{"-c:a",      "aac",        "-b:a", "96k",
                                     "-movflags", "+faststart", "-f",   "mp4"}
          : std::vector<std::string>{"-c:a", "libopus", "-b:a", "64k", "-f", "webm"};
  arguments.insert(arguments.end(), coding.begin(), coding.end());
  add_output("-flags:a", file, arguments);
  return arguments;
}

/// The picture with its last column and row repeated up to the given size.
std::vector<std::uint8_t> grown(const Image& picture, int width, int height) {
  std::vector<std::uint8_t> bytes;
  const std::size_t stride = static_cast<std::size_t>(picture.width) * 4;
  bytes.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (int y = 0; y < height; ++y) {
    const std::size_t row = static_cast<std::size_t>(std::min(y, picture.height - 1)) * stride;
    const auto begin = picture.rgba.begin() + static_cast<std::ptrdiff_t>(row);
    const auto end = begin + static_cast<std::ptrdiff_t>(stride);
    bytes.insert(bytes.end(), begin, end);
    for (int x = picture.width; x < width; ++x) bytes.insert(bytes.end(), end - 4, end);
  }
  return bytes;
}

int even(int side) {
  return side + side % 2;
}

Result<void> check_request(const std::filesystem::path& path, int width, int height, int fps) {
  if (!format_of(path).has_value()) {
    return Error{
        ErrorKind::Usage,
        at_place(
            path.string(),
            "not a kind of video that can be written: let its name end in .mp4, .webm or .gif")};
  }
  if (width < 1 || height < 1 || width > kVideoSideMax || height > kVideoSideMax) {
    return Error{ErrorKind::Usage, "a video of " + std::to_string(width) + "x" +
                                       std::to_string(height) + " is not possible: 1x1 to " +
                                       std::to_string(kVideoSideMax) + "x" +
                                       std::to_string(kVideoSideMax)};
  }
  if (fps < 1 || fps > kVideoFpsMax) {
    return Error{ErrorKind::Usage, std::to_string(fps) +
                                       " pictures a second are not possible: 1 to " +
                                       std::to_string(kVideoFpsMax)};
  }
  return {};
}

/// `code`: of Child::wait(), where 128 and more is the signal that killed it.
std::string how_it_ended(int code, const std::string& words) {
  constexpr int kSignal = 128;
  // The limit leaves it no time for words of its own.
  if (code == kSignal + SIGXFSZ) {
    return "was killed: the video is larger than a file may be here (ulimit -f)";
  }
  const std::string how = code >= kSignal ? "was killed by signal " + std::to_string(code - kSignal)
                                          : "ended with code " + std::to_string(code);
  return how + (words.empty() ? " and said nothing" : ": " + words);
}

Error not_started(const std::filesystem::path& path, const Error& error) {
  return ffmpeg_not_started(error, path.string(), "writes the video");
}

}  // namespace

struct VideoEncoder::State {
  std::filesystem::path path;
  TemporaryFile temporary;
  int width = 0;
  int height = 0;
  Format format = Format::Mp4;
  GivenUp stop;
  Milliseconds patience{0};
  Milliseconds idle_max{0};  ///< how long it may seem to do nothing once the user wants to stop
  Instant busy_at;           ///< when it was given something to do, or was seen to have written
  std::filesystem::file_time_type written_at;
  std::unique_ptr<Child> ffmpeg;  ///< after the file that it writes, so that it ends before
  std::size_t pictures = 0;
  std::optional<Error> failure;

  [[nodiscard]] bool stuck();
  void give_it_time(Milliseconds most);
  [[nodiscard]] Result<void> give_up();
  [[nodiscard]] Result<void> add_sound(const std::filesystem::path& sound);
};

void VideoEncoder::State::give_it_time(Milliseconds most) {
  idle_max = most;
  busy_at = std::chrono::steady_clock::now();
}

/// The end of a long video takes its time, in which ffmpeg writes.
bool VideoEncoder::State::stuck() {
  const Instant now = std::chrono::steady_clock::now();
  std::error_code ignored;
  const auto written = std::filesystem::last_write_time(temporary.path(), ignored);
  if (std::exchange(written_at, written) != written) busy_at = now;
  return stop && stop() && now - busy_at >= idle_max;
}

/// Makes an error of ffmpeg's last messages, after it has stopped reading.
Result<void> VideoEncoder::State::give_up() {
  const int code = ffmpeg->wait(patience);
  const std::string words = ffmpeg->error_tail();
  const std::string how = ffmpeg->killed() ? "hung and was killed when the video was to end" +
                                                 (words.empty() ? "" : ": " + words)
                                           : how_it_ended(code, words);
  failure = Error{ErrorKind::Failed, at_place(path.string(), "ffmpeg " + how)};
  ffmpeg.reset();
  temporary.remove();
  return *failure;
}

/// A second ffmpeg adds the sound and copies the pictures. A single one that gets both through
/// pipes reads them in turns of its own choosing, which can end in a deadlock.
Result<void> VideoEncoder::State::add_sound(const std::filesystem::path& sound) {
  auto whole = TemporaryFile::beside(path);
  if (!whole) return whole.error();
  const TemporaryFile silent = std::exchange(temporary, std::move(*whole));
  auto started = Child::start(muxing_arguments(format, silent.path(), sound, temporary.path()),
                              Child::Flow::Fed, [this] { return stuck(); });
  if (!started) return not_started(path, started.error());
  ffmpeg = std::move(*started);
  give_it_time(patience);
  if (ffmpeg->wait() != 0) return give_up();
  ffmpeg.reset();
  return {};
}

VideoEncoder::VideoEncoder(std::unique_ptr<State> state) : state_(std::move(state)) {}

VideoEncoder::~VideoEncoder() = default;

bool VideoEncoder::takes_sound(const std::filesystem::path& path) {
  const auto format = format_of(path);
  return format && *format != Format::Gif;
}

Result<std::unique_ptr<VideoEncoder>> VideoEncoder::open(const std::filesystem::path& path,
                                                         int width, int height, int fps,
                                                         GivenUp stop, Milliseconds patience) {
  if (const auto checked = check_request(path, width, height, fps); !checked.has_value()) {
    return checked.error();
  }
  auto state = std::make_unique<State>();
  state->path = path;
  state->format = *format_of(path);
  state->width = width;
  state->height = height;
  state->stop = std::move(stop);
  state->patience = patience;
  // Made now: after the last picture it would be too late to learn that the place is not writable.
  auto temporary = TemporaryFile::beside(path);
  if (!temporary.has_value()) return temporary.error();
  state->temporary = std::move(*temporary);
  const bool pairs = state->format != Format::Gif;
  auto ffmpeg =
      Child::start(ffmpeg_arguments(state->format, pairs ? even(width) : width,
                                    pairs ? even(height) : height, fps, state->temporary.path()),
                   Child::Flow::Fed, [state = state.get()] { return state->stuck(); });
  if (!ffmpeg.has_value()) return not_started(path, ffmpeg.error());
  state->ffmpeg = std::move(ffmpeg.value());
  return std::unique_ptr<VideoEncoder>(new VideoEncoder(std::move(state)));
}

Result<void> VideoEncoder::add(const Image& picture) {
  State& state = *state_;
  if (state.failure.has_value()) return *state.failure;
  AUCAST_CHECK(state.ffmpeg != nullptr);
  AUCAST_CHECK(picture.width == state.width);
  AUCAST_CHECK(picture.height == state.height);
  const bool fits = state.format == Format::Gif ||
                    (even(state.width) == state.width && even(state.height) == state.height);
  state.give_it_time(state.patience);
  const bool taken =
      fits ? state.ffmpeg->feed(picture.rgba)
           : state.ffmpeg->feed(grown(picture, even(state.width), even(state.height)));
  if (!taken) return state.give_up();
  ++state.pictures;
  return {};
}

Result<void> VideoEncoder::finish(const std::filesystem::path& sound) {
  State& state = *state_;
  if (state.failure.has_value()) return *state.failure;
  AUCAST_CHECK(state.ffmpeg != nullptr);
  if (state.pictures == 0) {
    state.ffmpeg.reset();
    state.temporary.remove();
    return {};
  }
  state.give_it_time(kEndPatience * state.patience);
  if (state.ffmpeg->wait() != 0) return state.give_up();
  state.ffmpeg.reset();
  if (!sound.empty() && state.format != Format::Gif) {
    if (auto added = state.add_sound(sound); !added) {
      state.failure = added.error();
      state.temporary.remove();
      return added;
    }
  }
  if (const auto replaced = state.temporary.replace(state.path); !replaced.has_value()) {
    state.failure = replaced.error();
    return *state.failure;
  }
  return {};
}

}  // namespace aucast::view
