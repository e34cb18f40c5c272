#include <cstdio>
#include <filesystem>

#include "common/files.h"
#include "common/number_of.h"
#include "scripts/facegen/head.h"
#include "scripts/facegen/variation.h"

int main(int argument_count, char** arguments) {
  using namespace aucast;
  if (argument_count < 2 || argument_count > 4) {
    std::fprintf(stderr,
                 "usage: facegen FACE_FOLDER [IDENTITY [NUMBER]]   (writes mesh.ply into it)\n"
                 "NUMBER: somebody else who looks a little like IDENTITY; 0 is IDENTITY\n");
    return exit_code({ErrorKind::Usage, {}});
  }
  const facegen::Identity* who = &facegen::default_identity();
  if (argument_count >= 3) who = facegen::identity_named(arguments[2]);
  if (who == nullptr) {
    std::fprintf(stderr, "facegen: no identity '%s'; see identity.cpp\n", arguments[2]);
    return exit_code({ErrorKind::Usage, {}});
  }
  const auto number = argument_count == 4 ? number_of<std::uint32_t>(arguments[3]) : 0;
  if (!number) {
    std::fprintf(stderr, "facegen: '%s' is not a whole number from 0 on\n", arguments[3]);
    return exit_code({ErrorKind::Usage, {}});
  }
  const std::string_view other = who->name == "marek" ? "default" : "marek";
  const facegen::Identity person = facegen::varied(*who, *facegen::identity_named(other), *number);
  const std::filesystem::path file = std::filesystem::path{arguments[1]} / "mesh.ply";
  const std::string bytes = facegen::head_file(facegen::make_head(person));
  const Result<void> written = write_file_atomically(file, bytes);
  if (!written) {
    std::fprintf(stderr, "facegen: %s\n", written.error().message.c_str());
    return exit_code(written.error());
  }
  return 0;
}
