#include "server/engine/nats_loader.h"

#include <dlfcn.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>

#include <array>
#include <string>
#include <string_view>
#include <system_error>

#include "common/files.h"
#include "common/text.h"

namespace aucast::server {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFile = "aucast-nats.so";

/// Whether the user is alone in the group, which many systems give each user under their own name:
/// it is called as they are, is theirs from the start, and lists nobody else.
bool is_alone(uid_t user, gid_t group) {
  // What does not fit is a group of many.
  std::array<char, 4096> user_text{};
  std::array<char, 4096> group_text{};
  struct passwd user_space {};
  struct group group_space {};
  struct passwd* owner = nullptr;
  struct group* theirs = nullptr;
  ::getpwuid_r(user, &user_space, user_text.data(), user_text.size(), &owner);
  ::getgrgid_r(group, &group_space, group_text.data(), group_text.size(), &theirs);
  if (owner == nullptr || theirs == nullptr) return false;
  const std::string_view name(owner->pw_name);
  if (owner->pw_gid != group || name != theirs->gr_name) return false;
  for (char** member = theirs->gr_mem; *member != nullptr; ++member) {
    if (name != *member) return false;
  }
  return true;
}

/// Whether nobody but root and the owner of this program can have put it there.
bool only_ours(const fs::path& path) {
  struct stat program {};
  struct stat status {};
  if (::stat("/proc/self/exe", &program) != 0 || ::stat(path.c_str(), &status) != 0) return false;
  if (status.st_uid != 0 && status.st_uid != program.st_uid) return false;
  if ((status.st_mode & S_IWOTH) != 0) return false;
  return (status.st_mode & S_IWGRP) == 0 || is_alone(0, status.st_gid) ||
         is_alone(program.st_uid, status.st_gid);
}

Error not_loaded(const fs::path& file, const std::string& why) {
  return Error{ErrorKind::Unreadable, at_place(file.string(), "not loaded: " + why)};
}

Result<const NatsModule*> load(const fs::path& file) {
  if (!only_ours(file) || !only_ours(file.parent_path())) {
    return not_loaded(file,
                      "others than root and the owner of au-transmitter could have written it; "
                      "look at the rights of it and of its folder (chmod go-w)");
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
