#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "common/result.h"
#include "common/web/http.h"
#include "server/http/http_exchanges.h"

namespace aucast::server {

/// The files of the page, read once. Thread: none of its own.
class PageFiles {
 public:
  /// Reads all regular files below `folder` except those whose names begin with a dot; NAME.gz
  /// beside NAME is the same file compressed. If the folder does not exist, there are no files.
  /// Fails with Unreadable and a message that names the file and the cause.
  [[nodiscard]] static Result<PageFiles> read(const std::filesystem::path& folder);

  /// Whether there is a page, /index.html, which is also the reply to "/".
  [[nodiscard]] bool has_page() const { return files_.contains("/index.html"); }
  [[nodiscard]] std::size_t size() const { return files_.size(); }

  /// The reply to a request: the file, compressed if the client accepts that; 304 if the client has
  /// it already; 404 if there is no such file.
  [[nodiscard]] SharedReply reply(const web::HttpRequest& request) const;

 private:
  struct File {
    std::string type;
    SharedBytes plain;
    SharedBytes compressed;  ///< null: there is none
    std::string plain_tag;   ///< ETag, in quotes
    std::string compressed_tag;
  };

  std::map<std::string, File, std::less<>> files_;  ///< by path: "/index.html"
};

/// The Content-Type for a file's extension.
[[nodiscard]] std::string content_type(const std::filesystem::path& file);

}  // namespace aucast::server
