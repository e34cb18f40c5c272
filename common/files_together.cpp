#include "common/files_together.h"

#include <cerrno>
#include <cstdio>
#include <memory>

#include "common/files.h"
#include "common/text.h"

namespace aucast {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Fails with the reason of the first write that did: of what follows, another one may be left.
Result<void> write_to(const std::filesystem::path& temporary, const std::filesystem::path& path,
                      const std::function<void(const FilesTogether::Append&)>& write) {
  int reason = 0;
  std::unique_ptr<std::FILE, Close> file(std::fopen(temporary.c_str(), "wbe"));
  if (!file) reason = errno;
  const auto append = [&](std::string_view bytes) {
    if (reason != 0) return;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) reason = errno;
  };
  write(append);
  if (file && std::fclose(file.release()) != 0 && reason == 0) reason = errno;
  if (reason == 0) return {};
  return Error{ErrorKind::Failed,
               at_place(path.string(), "cannot be written whole: " + system_reason(reason))};
}

}  // namespace

Result<void> FilesTogether::add(const std::filesystem::path& path,
                                const std::function<void(const Append&)>& write) {
  if (written_directly(path)) {
    if (auto writable = check_writable(path); !writable) return writable;
    std::string& kept = direct_.emplace_back("", path).first;
    write([&kept](std::string_view bytes) { kept += bytes; });
    return {};
  }
  auto temporary = TemporaryFile::beside(path);
  if (!temporary) return temporary.error();
  if (auto written = write_to(temporary->path(), path, write); !written) return written;
  files_.emplace_back(std::move(*temporary), path);
  return {};
}

Result<void> FilesTogether::add(const std::filesystem::path& path, std::string_view bytes) {
  return add(path, [bytes](const Append& append) { append(bytes); });
}

Result<void> FilesTogether::finish() {
  for (const auto& [bytes, path] : direct_) {
    if (auto written = write_file_atomically(path, bytes); !written) return written;
  }
  for (auto& [temporary, path] : files_) {
    if (auto replaced = temporary.replace(path); !replaced) return replaced;
  }
  return {};
}

}  // namespace aucast
