#include <mpg123.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "common/files.h"
#include "common/text.h"
#include "common/voice/sound_reader.h"

namespace aucast::voice {
namespace {

constexpr std::size_t kTagHeader = 10;
/// More tags than this before the sound are no MP3 file; each takes a read.
constexpr int kTagsMax = 16;
/// As far into the first frame as a Xing header can begin.
constexpr std::size_t kLookBytes = 64;
/// What writers of Xing headers disagree about: whether the frame that has it counts.
constexpr std::int64_t kOwnFrame = 1;

unsigned byte_of(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

/// Where the first frame should be: after the tags of ID3v2, each of which tells its length in four
/// times seven bits.
std::int64_t after_tags(int descriptor) {
  std::int64_t at = 0;
  for (int tags = 0; tags < kTagsMax; ++tags) {
    const std::string tag = bytes_at(descriptor, at, kTagHeader);
    if (tag.size() < kTagHeader || !tag.starts_with("ID3")) break;
    std::int64_t length = 0;
    for (std::size_t i = 6; i < kTagHeader; ++i) length = length * 128 + (byte_of(tag, i) & 127U);
    at += static_cast<std::int64_t>(kTagHeader) + length;
  }
  return at;
}

/// Whether a frame of MPEG audio begins there.
bool is_frame(std::string_view bytes) {
  if (bytes.size() < 4 || byte_of(bytes, 0) != 0xff) return false;
  const unsigned second = byte_of(bytes, 1);
  const unsigned third = byte_of(bytes, 2);
  const unsigned version = second >> 3U & 3U;
  const unsigned layer = second >> 1U & 3U;
  return second >= 0xe0 && version != 1 && layer != 0 && third >> 4U != 15 &&
         (third >> 2U & 3U) != 3;
}

/// How many frames the Xing header says there are, if the first frame has one that does.
std::optional<std::int64_t> frames_told(std::string_view first_frame) {
  for (const std::string_view name : {"Xing", "Info"}) {
    const std::size_t at = first_frame.find(name);
    if (at == std::string_view::npos || first_frame.size() < at + 12) continue;
    constexpr unsigned kHasFrames = 1;
    if ((byte_of(first_frame, at + 7) & kHasFrames) == 0) return std::nullopt;
    std::int64_t frames = 0;
    for (std::size_t i = at + 8; i < at + 12; ++i) frames = frames * 256 + byte_of(first_frame, i);
    return frames;
  }
  return std::nullopt;
}

struct DeleteDecoder {
  void operator()(mpg123_handle* decoder) const { mpg123_delete(decoder); }
};

class Mp3Reader final : public SoundReader {
 public:
  explicit Mp3Reader(Descriptor file) : file_(std::move(file)) {
    // A no-op since 1.27.
    static const int kInitialised = mpg123_init();
    if (kInitialised == MPG123_OK) decoder_.reset(mpg123_new(nullptr, nullptr));
  }

  /// Why it cannot be read; empty: it can.
  [[nodiscard]] std::string begin() {
    mpg123_handle* const decoder = decoder_.get();
    if (decoder == nullptr) return "libmpg123 does not work";
    mpg123_param(decoder, MPG123_ADD_FLAGS, MPG123_QUIET | MPG123_FORCE_FLOAT | MPG123_MONO_MIX, 0);
    int channels = 0;
    int encoding = 0;
    if (mpg123_open_fd(decoder, file_.get()) != MPG123_OK ||
        mpg123_getformat(decoder, &rate_, &channels, &encoding) != MPG123_OK ||
        mpg123_scan(decoder) != MPG123_OK) {
      return mpg123_strerror(decoder);
    }
    count_ = mpg123_length(decoder);
    if (count_ < 1 || channels != 1 || encoding != MPG123_ENC_FLOAT_32) return "it has no samples";
    const std::string first = bytes_at(file_.get(), after_tags(file_.get()), kLookBytes);
    const std::int64_t there = mpg123_framelength(decoder);
    const auto told = frames_told(first);
    all_there_ = told && *told <= there + kOwnFrame;
    if (told && !all_there_) {
      missing_ = "of " + counted(static_cast<std::uint64_t>(*told), "frame") + " it has " +
                 std::to_string(there);
    }
    return {};
  }

  [[nodiscard]] int rate() const override { return static_cast<int>(rate_); }
  [[nodiscard]] std::int64_t count() const override { return count_; }

  [[nodiscard]] std::size_t read(std::span<float> samples) override {
    const auto bytes = std::as_writable_bytes(samples);
    std::size_t done = 0;
    while (done < bytes.size() && !ended_) {
      std::size_t got = 0;
      const int state = mpg123_read(decoder_.get(), bytes.data() + done, bytes.size() - done, &got);
      done += got;
      ended_ = state != MPG123_OK || got == 0;
      if (ended_) end(state);
    }
    return done / sizeof(float);
  }

  [[nodiscard]] std::string complaint() const override { return complaint_; }
  [[nodiscard]] bool damaged() const override { return damaged_; }

 private:
  void end(int state) {
    const std::string error = mpg123_strerror(decoder_.get());
    const bool changes = state == MPG123_NEW_FORMAT;
    damaged_ = changes || (state == MPG123_ERR && !only_tags_follow());
    complaint_ = missing_;
    if (damaged_) complaint_ = changes ? "its sample rate changes" : error;
  }

  [[nodiscard]] bool found_no_frame() const {
    return mpg123_errcode(decoder_.get()) == MPG123_RESYNC_FAIL;
  }

  /// After an error: whether the sound is over, and libmpg123 stumbles over what some programs put
  /// behind it, such as tags of APE and Lyrics3. It looks for a frame in the next 1024 bytes, and
  /// goes on behind them when it is asked again.
  [[nodiscard]] bool only_tags_follow() {
    if (!found_no_frame()) return false;
    if (all_there_) return true;
    std::array<std::byte, 4096> sound{};
    std::size_t got = 0;
    int state = MPG123_ERR;
    while (state == MPG123_ERR && got == 0 && found_no_frame()) {
      state = mpg123_read(decoder_.get(), sound.data(), sound.size(), &got);
    }
    return state == MPG123_DONE && got == 0;
  }

  Descriptor file_;
  std::unique_ptr<mpg123_handle, DeleteDecoder> decoder_;
  long rate_ = 0;
  std::int64_t count_ = 0;
  bool all_there_ = false;  ///< all frames that the Xing header tells of
  std::string missing_;
  std::string complaint_;
  bool damaged_ = false;
  bool ended_ = false;  ///< after an error libmpg123 would go on behind what is broken
};

}  // namespace

bool is_mp3(int descriptor) {
  const std::int64_t begin = after_tags(descriptor);
  const std::string first = bytes_at(descriptor, begin, 4);
  if (is_frame(first)) return true;
  // Such tags are rare before other kinds. Behind them in an MP3 file there may be padding first.
  constexpr std::array<std::string_view, 5> kOthers{"fLaC", "FORM", "RIFF", "OggS", "ID3"};
  const bool other = std::any_of(kOthers.begin(), kOthers.end(), [&first](std::string_view kind) {
    return first.starts_with(kind);
  });
  return begin > 0 && !other;
}

Result<std::unique_ptr<SoundReader>> open_mp3(Descriptor file) {
  auto reader = std::make_unique<Mp3Reader>(std::move(file));
  if (std::string why = reader->begin(); !why.empty()) {
    return Error{ErrorKind::BadData, std::move(why)};
  }
  return std::unique_ptr<SoundReader>(std::move(reader));
}

}  // namespace aucast::voice
