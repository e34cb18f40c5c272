#include "common/camera/picture_source.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "common/ffmpeg.h"
#include "common/files.h"
#include "common/film_name.h"
#include "common/number_of.h"
#include "common/text.h"

namespace aucast::camera {
namespace {

/// How long ffmpeg may take to end after its last picture.
constexpr Milliseconds kEndTakes{2000};

/// Square pixels, then 640 at most; the longer side of a face net's input is 192.
constexpr const char* kFilters =
    "scale='max(1,trunc(iw*sar))':ih,"
    "scale=w='max(2,trunc(iw*min(1,640/max(iw,ih))))':h='max(2,trunc(ih*min(1,640/max(iw,ih))))'"
    ":out_color_matrix=bt601:out_range=tv,setsar=1";

std::vector<std::string> arguments_of(std::vector<std::string> input, const std::string& filters) {
  std::vector<std::string> arguments{kFfmpeg, "-nostdin", "-hide_banner", "-loglevel", "error"};
  for (std::string& word : input) arguments.push_back(std::move(word));
  for (const char* word : {"-map", "0:V:0", "-an", "-sn", "-dn", "-vf"})
    arguments.emplace_back(word);
  arguments.push_back(filters);
  for (const char* word :
       {"-pix_fmt", "yuv444p", "-strict", "-1", "-f", "yuv4mpegpipe", "pipe:1"}) {
    arguments.emplace_back(word);
  }
  return arguments;
}

/// A message of ffmpeg without the "[NAME @ ADDRESS] " of the component that wrote it.
std::string without_component(const std::string& words) {
  const std::size_t end = words.find("] ");
  const bool named = words.starts_with('[') && end != std::string::npos;
  return named ? words.substr(end + 2) : words;
}

/// False: no picture came in time, or the caller gave up.
bool await_picture(Child& ffmpeg, Milliseconds patience, const GivenUp& given_up) {
  constexpr Milliseconds kAskEvery{50};
  for (Milliseconds left = patience; left > Milliseconds::zero(); left -= kAskEvery) {
    if (ffmpeg.await(std::min(left, kAskEvery))) return true;
    if (given_up && given_up()) return false;
  }
  return false;
}

/// `name`: of the film or camera, for the message.
Result<std::unique_ptr<Child>> start_ffmpeg(const std::vector<std::string>& arguments,
                                            const std::string& name, GivenUp given_up = {}) {
  auto child = Child::start(arguments, Child::Flow::Read, std::move(given_up));
  if (child) return child;
  return ffmpeg_not_started(child.error(), name, "decodes it");
}

}  // namespace

Result<PictureSource> PictureSource::open(std::unique_ptr<Child> ffmpeg, const std::string& name,
                                          ErrorKind kind) {
  PictureSource source;
  source.ffmpeg_ = std::move(ffmpeg);
  auto pictures = Y4mReader::open(
      [child = source.ffmpeg_.get()](std::span<std::uint8_t> bytes) { return child->read(bytes); });
  if (!pictures) return Error{kind, at_place(name, pictures.error().message)};
  if (!*pictures) {
    return no_pictures(kind, name, source.complaint());
  }
  source.pictures_ = std::move(*pictures);
  return source;
}

Result<PictureSource> PictureSource::open_film(const std::filesystem::path& path,
                                               const GivenUp& given_up) {
  if (const auto file = open_file(path); !file) return file.error();
  auto ffmpeg = start_ffmpeg(arguments_of({"-i", ffmpeg_name(path)},
                                          "fps=fps='min(source_fps,30)'," + std::string(kFilters)),
                             path.string(), given_up);
  if (!ffmpeg) return ffmpeg.error();
  return open(*std::move(ffmpeg), path.string(), ErrorKind::BadData);
}

Result<PictureSource> PictureSource::open_device(const std::vector<std::string>& arguments,
                                                 const CameraOptions& options,
                                                 const GivenUp& given_up) {
  auto ffmpeg = start_ffmpeg(arguments, options.device);
  if (!ffmpeg) return ffmpeg.error();
  if (!await_picture(**ffmpeg, options.patience, given_up)) {
    return Error{ErrorKind::Failed,
                 at_place(options.device, "no picture came for " +
                                              std::to_string(options.patience.count() / 1000) +
                                              " s; is another program using it?")};
  }
  return open(*std::move(ffmpeg), options.device, ErrorKind::Failed);
}

Result<PictureSource> PictureSource::open_camera(const CameraOptions& options,
                                                 const GivenUp& given_up) {
  const std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
  std::vector<std::string> input{
      "-fflags",     "nobuffer",    "-f",         "v4l2",
      "-video_size", size,          "-framerate", std::to_string(options.fps),
      "-i",          options.device};
  std::error_code ignored;
  const auto status = std::filesystem::status(options.device, ignored);
  if (std::filesystem::is_regular_file(status)) {
    input = {"-re", "-i", ffmpeg_name(options.device)};
  } else if (std::filesystem::is_fifo(status)) {
    input = {"-fflags", "nobuffer", "-i", ffmpeg_name(options.device)};
  }
  // Nothing is buffered that can be shown: a late face is worth nothing.
  auto opened = open_device(arguments_of(std::move(input), kFilters), options, given_up);
  if (!opened && !std::filesystem::exists(status)) {
    if (is_film(options.device)) {
      if (const auto film = open_film(options.device, given_up); !film) return film.error();
    }
    return Error{ErrorKind::Failed,
                 at_place(options.device,
                          "there is no such camera; plug it in, or name another one or a film")};
  }
  return opened;
}

std::string PictureSource::complaint() {
  const int code = ffmpeg_->wait(kEndTakes);
  return code == 0 ? std::string() : without_component(ffmpeg_->error_tail());
}

std::string PictureSource::film_complaint() {
  static_cast<void>(ffmpeg_->wait(kEndTakes));
  // Of a film that breaks off it has much to say, of which the last is enough.
  std::string words = without_component(ffmpeg_->last_line());
  return words.empty() && pictures_->torn() ? "the last picture is cut off" : words;
}

Error no_pictures(ErrorKind kind, const std::string& name, const std::string& complaint) {
  return {kind, at_place(name, "there are no pictures in it" +
                                   (complaint.empty() ? "" : "; ffmpeg says: " + complaint))};
}

std::optional<double> film_seconds(const std::filesystem::path& path, const GivenUp& given_up) {
  auto probe = Child::start({"ffprobe", "-v", "error", "-show_entries", "format=duration", "-of",
                             "csv=p=0", ffmpeg_name(path)},
                            Child::Flow::Read, given_up);
  if (!probe) return std::nullopt;
  std::string text;
  std::vector<std::uint8_t> chunk(256);
  while (text.size() < chunk.size()) {  // a number is shorter
    const std::size_t got = (*probe)->read(chunk);
    if (got == 0) break;
    text.append(chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(got));
  }
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const auto seconds = number_of<double>(text);
  if (!seconds || !(*seconds > 0)) return std::nullopt;
  return seconds;
}

}  // namespace aucast::camera
