#include "server/web/page_files.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include "common/check.h"
#include "common/files.h"
#include "common/text.h"
#include "common/text_file.h"

namespace aucast::server {
namespace {

namespace fs = std::filesystem;

/// More than a page with all its faces takes; a larger folder is no page.
constexpr std::size_t kFileBytesMax = std::size_t{64} << 20U;
constexpr std::size_t kFilesMax = 2000;
constexpr std::uintmax_t kMebibytesMax = 256;  ///< of all files, which are kept in memory

/// Nothing from other sites may run or be shown; `wasm-unsafe-eval` allows only WebAssembly. A page
/// may be hosted apart from its server, so it may connect to any WebSocket.
constexpr const char* kContentSecurityPolicy =
    "Content-Security-Policy: default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; "
    "style-src 'self'; img-src 'self' data: blob:; font-src 'self'; "
    "media-src 'self' blob:; worker-src 'self' blob:; connect-src 'self' ws: wss:; "
    "manifest-src 'self'; base-uri 'none'; form-action 'none'";

/// An ETag: half a SHA-256 in quotes.
std::string tag_of(std::string_view bytes) {
  constexpr std::size_t kTagBytes = 16;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  AUCAST_CHECK(
      EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) == 1);
  std::string tag = "\"";
  for (std::size_t i = 0; i < kTagBytes; ++i) {
    tag += kDigits[digest[i] >> 4U];
    tag += kDigits[digest[i] & 0xfU];
  }
  return tag + "\"";
}

Error too_much(const fs::path& folder, std::uintmax_t most, const char* of_what) {
  return {ErrorKind::Unreadable,
          at_place(folder.string(), "holds more than " + std::to_string(most) + " " + of_what +
                                        "; take out what does not belong to the page")};
}

/// The paths below `folder`, as in a request.
Result<std::vector<std::string>> paths_below(const fs::path& folder) {
  std::vector<std::string> paths;
  std::uintmax_t bytes = 0;
  std::error_code error;
  const auto fail = [&error](const fs::path& place) {
    return Error{
        ErrorKind::Unreadable,
        at_place(place.string(), "cannot be read: " + error.message() + "; check its permissions")};
  };
  fs::recursive_directory_iterator entry(folder, error);
  if (error) return fail(folder);
  while (entry != fs::recursive_directory_iterator()) {
    const fs::path path = entry->path();
    const bool hidden = path.filename().string().starts_with('.');
    if (hidden) entry.disable_recursion_pending();
    if (!hidden && !entry->is_directory(error)) {
      paths.push_back("/" + path.lexically_relative(folder).generic_string());
      std::error_code unknown;  // what has no size is said when it is read
      const std::uintmax_t size = entry->file_size(unknown);
      if (!unknown) bytes += size;
    }
    if (paths.size() > kFilesMax) return too_much(folder, kFilesMax, "files");
    if (bytes > kMebibytesMax << 20U) return too_much(folder, kMebibytesMax, "MiB");
    entry.increment(error);
    if (error) return fail(folder);
  }
  return paths;
}

/// If-None-Match: whether the client has the file with this tag.
bool is_known(std::string_view tags, std::string_view tag) {
  const std::vector<std::string_view> parts = split(tags, ',');
  return std::any_of(parts.begin(), parts.end(), [tag](std::string_view part) {
    part = trimmed(part, " \t");
    if (part.starts_with("W/")) part.remove_prefix(2);
    return part == tag || part == "*";
  });
}

}  // namespace

std::string content_type(const fs::path& file) {
  static const std::map<std::string, std::string, std::less<>> kTypes = {
      {".css", "text/css; charset=utf-8"},
      {".html", "text/html; charset=utf-8"},
      {".ico", "image/vnd.microsoft.icon"},
      {".jpg", "image/jpeg"},
      {".js", "text/javascript; charset=utf-8"},
      {".json", "application/json"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".png", "image/png"},
      {".svg", "image/svg+xml"},
      {".toml", "application/toml"},
      {".txt", "text/plain; charset=utf-8"},
      {".vtt", "text/vtt; charset=utf-8"},
      {".wasm", "application/wasm"},
      {".webmanifest", "application/manifest+json"},
      {".woff2", "font/woff2"},
  };
  const auto found = kTypes.find(file.extension().string());
  return found == kTypes.end() ? "application/octet-stream" : found->second;
}

Result<PageFiles> PageFiles::read(const fs::path& folder) {
  PageFiles page;
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return page;
  const auto paths = paths_below(folder);
  if (!paths) return paths.error();
  std::map<std::string, std::string, std::less<>> bytes;
  for (const std::string& path : *paths) {
    auto read = read_file(folder / path.substr(1), kFileBytesMax);
    if (!read) return read.error();
    bytes.emplace(path, std::move(*read));
  }
  for (auto& [path, plain] : bytes) {
    const bool beside = path.ends_with(".gz") && bytes.contains(path.substr(0, path.size() - 3));
    if (beside) continue;
    File file{content_type(path), nullptr, nullptr, tag_of(plain), {}};
    if (const auto compressed = bytes.find(path + ".gz"); compressed != bytes.end()) {
      file.compressed_tag = tag_of(compressed->second);
      file.compressed = std::make_shared<const std::string>(std::move(compressed->second));
    }
    file.plain = std::make_shared<const std::string>(std::move(plain));
    page.files_.emplace(path, std::move(file));
  }
  return page;
}

SharedReply PageFiles::reply(const web::HttpRequest& request) const {
  const auto found = files_.find(request.path == "/" ? "/index.html" : request.path);
  if (found == files_.end()) {
    const bool unbuilt = request.path == "/" && !has_page();
    return {{.status = 404,
             .body = unbuilt ? "the page is not installed here (scripts/build_web.sh builds it); "
                               "/aucast is a WebSocket for other clients\n"
                             : "there is no such file; / is the page, /aucast a WebSocket\n"},
            nullptr};
  }
  const File& file = found->second;
  const bool compress = file.compressed && web::has_word(request.field("accept-encoding"), "gzip");
  const std::string& tag = compress ? file.compressed_tag : file.plain_tag;
  SharedReply reply;
  // Asked for anew each time, and answered by 304 as long as it is the same.
  reply.head.cache = "no-cache";
  reply.head.type = file.type;
  // Pages of other hosts may hold a face: the files are no secret.
  reply.head.fields = {"ETag: " + tag,
                       "Vary: Accept-Encoding",
                       "Access-Control-Allow-Origin: *",
                       "Cross-Origin-Resource-Policy: cross-origin",
                       "Referrer-Policy: no-referrer",
                       kContentSecurityPolicy};
  if (is_known(request.field("if-none-match"), tag)) {
    reply.head.status = 304;
    reply.head.type.clear();
    return reply;
  }
  if (compress) reply.head.fields.emplace_back("Content-Encoding: gzip");
  reply.body = compress ? file.compressed : file.plain;
  return reply;
}

}  // namespace aucast::server
