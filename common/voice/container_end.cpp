#include "common/voice/container_end.h"

#include <algorithm>
#include <string_view>

#include "common/files.h"
#include "common/text.h"

namespace aucast::voice {
namespace {

/// What programs that write WAV to a pipe put for a size that they do not know begins here.
constexpr std::uint64_t kUnknownSizes = 0x7fff'0000;
constexpr std::size_t kChunkHeader = 8;
/// More chunks than this before the sound is no sound file.
constexpr int kChunksMax = 1000;

constexpr std::size_t kPageHeader = 27;
/// Of an Ogg page with its header and all of its segments.
constexpr std::size_t kPageBytesMax = kPageHeader + 255 + 255 * 255;
constexpr std::size_t kPageFlags = 5;
constexpr unsigned kLastPage = 4;

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte) {
    number = number << 8U | static_cast<unsigned char>(*byte);
  }
  return number;
}

ContainerEnd end_of_wav(int descriptor) {
  constexpr std::int64_t kFirstChunk = 12;
  const std::int64_t size = file_size(descriptor);
  std::uint64_t long_size = 0;
  std::int64_t at = kFirstChunk;
  for (int i = 0; i < kChunksMax && at < size; ++i) {
    const std::string chunk = bytes_at(descriptor, at, kChunkHeader + 16);
    if (chunk.size() < kChunkHeader) break;
    const std::string_view name = std::string_view(chunk).substr(0, 4);
    std::uint64_t told = little_endian(std::string_view(chunk).substr(4, 4));
    at += std::int64_t{kChunkHeader};
    if (name == "ds64" && chunk.size() == kChunkHeader + 16) {
      long_size = little_endian(std::string_view(chunk).substr(kChunkHeader + 8, 8));
    }
    if (name == "data") {
      const bool unknown = told == 0 || told >= kUnknownSizes;
      if (unknown) told = long_size;
      const auto there = static_cast<std::uint64_t>(size - at);
      if (told <= there) return {};
      return {"of " + counted(told, "byte") + " of sound it has " + std::to_string(there)};
    }
    at += static_cast<std::int64_t>(told + told % 2);
  }
  return {};
}

/// Where the last page that is whole begins in the bytes at the end of an Ogg file, if one ends
/// where they end.
std::size_t last_page(std::string_view bytes) {
  for (std::size_t at = bytes.rfind("OggS"); at != std::string_view::npos;
       at = at == 0 ? std::string_view::npos : bytes.rfind("OggS", at - 1)) {
    const std::string_view page = bytes.substr(at);
    if (page.size() < kPageHeader) continue;
    const auto segments = static_cast<unsigned char>(page[kPageHeader - 1]);
    if (page.size() < kPageHeader + segments) continue;
    std::size_t length = kPageHeader + segments;
    for (const char segment : page.substr(kPageHeader, segments)) {
      length += static_cast<unsigned char>(segment);
    }
    if (length == page.size()) return at;
  }
  return std::string_view::npos;
}

ContainerEnd end_of_ogg(int descriptor) {
  const std::int64_t size = file_size(descriptor);
  const std::int64_t begin = std::max<std::int64_t>(size - std::int64_t{kPageBytesMax}, 0);
  const std::string bytes = bytes_at(descriptor, begin, kPageBytesMax);
  const std::size_t page = last_page(bytes);
  if (page == std::string::npos) return {"it ends within a page", true};
  const auto flags = static_cast<unsigned char>(bytes[page + kPageFlags]);
  if ((flags & kLastPage) == 0) return {"its last page is missing"};
  return {};
}

}  // namespace

ContainerEnd container_end(int descriptor) {
  const std::string begin = bytes_at(descriptor, 0, 12);
  const bool riff = begin.starts_with("RIFF") || begin.starts_with("RF64");
  if (riff && begin.ends_with("WAVE")) return end_of_wav(descriptor);
  if (begin.starts_with("OggS")) return end_of_ogg(descriptor);
  return {};
}

}  // namespace aucast::voice
