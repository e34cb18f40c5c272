#include "client/app/window/making/shipped_copies.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "common/files.h"

namespace aucast::app {

namespace fs = std::filesystem;

bool ShippedCopies::contain(const fs::path& face) {
  // A face may use files of the default one beside it.
  return same(face) && same(face.parent_path() / "default");
}

ShippedCopies::Files ShippedCopies::files_in(const fs::path& folder) {
  Files files;
  std::error_code failed;
  for (fs::recursive_directory_iterator at(folder, failed), end; !failed && at != end;
       at.increment(failed)) {
    if (at->is_directory(failed)) continue;
    File file;
    file.size = at->file_size(failed);
    if (!failed) file.written = at->last_write_time(failed);
    if (failed) break;
    files.emplace(at->path().lexically_relative(folder), file);
  }
  return failed ? Files() : files;
}

bool ShippedCopies::same_files(const fs::path& here, const fs::path& there, const Compared& files) {
  const auto as_large = [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.size == b.second.size;
  };
  if (files.here.empty() || !std::equal(files.here.begin(), files.here.end(), files.shipped.begin(),
                                        files.shipped.end(), as_large)) {
    return false;
  }
  return std::all_of(files.here.begin(), files.here.end(), [&](const auto& file) {
    const auto mine = read_file(here / file.first);
    const auto shipped = read_file(there / file.first);
    return mine && shipped && *mine == *shipped;
  });
}

bool ShippedCopies::same(const fs::path& folder) {
  const fs::path shipped = shipped_ / folder.filename();
  std::error_code gone;
  if (!fs::is_directory(shipped, gone)) return false;
  Compared now{files_in(folder), files_in(shipped)};
  Compared& before = compared_[folder];
  if (now.here == before.here && now.shipped == before.shipped) return before.same;
  now.same = same_files(folder, shipped, now);
  before = std::move(now);
  return before.same;
}

}  // namespace aucast::app
