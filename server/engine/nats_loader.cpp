#include "server/engine/nats_loader.h"

#include <dlfcn.h>
#include <sys/stat.h>

#include <string>
#include <string_view>
#include <system_error>

#include "common/files.h"
#include "common/text.h"

namespace aucast::server {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFile = "aucast-nats.so";

/// Whether nobody else can have put it there: it belongs to root or to the owner of this program.
bool only_ours(const fs::path& path) {
  struct stat program {};
  struct stat status {};
  return ::stat("/proc/self/exe", &program) == 0 && ::stat(path.c_str(), &status) == 0 &&
         (status.st_uid == 0 || status.st_uid == program.st_uid) && (status.st_mode & S_IWOTH) == 0;
}

Error not_loaded(const fs::path& file, const std::string& why) {
  return Error{ErrorKind::Unreadable, at_place(file.string(), "not loaded: " + why)};
}

Result<const NatsModule*> load(const fs::path& file) {
  if (!only_ours(file) || !only_ours(file.parent_path())) {
    return not_loaded(file,
                      "others than root and the owner of au-transmitter could have written it");
  }
  void* const handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) {
    const char* const said = ::dlerror();
    return not_loaded(file, said == nullptr ? "the system gives no reason" : said);
  }
  const auto* const module = static_cast<const NatsModule*>(::dlsym(handle, kNatsModule));
  const std::string_view tag = module == nullptr ? "nothing of AUcast" : module->tag;
  if (tag != AUCAST_NATS_TAG) {
    return not_loaded(file, "it is " + printable(tag) + ", and this au-transmitter is " +
                                AUCAST_NATS_TAG + "; install both from one build");
  }
  return module;
}

}  // namespace

std::vector<fs::path> nats_module_folders() {
  const auto programs = program_folder();
  if (!programs) return {};
  return {*programs, (*programs / AUCAST_NATS_FOLDER).lexically_normal()};
}

Result<const NatsModule*> load_nats_module(const std::vector<fs::path>& folders) {
  std::string tried;
  for (const fs::path& folder : folders) {
    std::error_code error;
    if (fs::exists(folder / kFile, error)) return load(folder / kFile);
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  return Error{ErrorKind::Usage, std::string("NATS is not installed: the package aucast-nats has "
                                             "it, and a build with AUCAST_NATS (no ") +
                                     kFile + " in " + printable(tried) +
                                     "); aucast:// for relays needs none"};
}

}  // namespace aucast::server
