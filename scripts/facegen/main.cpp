#include <cstdio>
#include <filesystem>

#include "common/files.h"
#include "scripts/facegen/head.h"

int main(int argument_count, char** arguments) {
  using namespace aucast;
  if (argument_count != 2 && argument_count != 3) {
    std::fprintf(stderr, "usage: facegen FACE_FOLDER [IDENTITY]   (writes mesh.ply into it)\n");
    return exit_code({ErrorKind::Usage, {}});
  }
  const facegen::Identity* who = &facegen::default_identity();
  if (argument_count == 3) who = facegen::identity_named(arguments[2]);
  if (who == nullptr) {
    std::fprintf(stderr, "facegen: no identity '%s'; see identity.cpp\n", arguments[2]);
    return exit_code({ErrorKind::Usage, {}});
  }
  const std::filesystem::path file = std::filesystem::path{arguments[1]} / "mesh.ply";
  const std::string bytes = facegen::head_file(facegen::make_head(*who));
  const Result<void> written = write_file_atomically(file, bytes);
  if (!written) {
    std::fprintf(stderr, "facegen: %s\n", written.error().message.c_str());
    return exit_code(written.error());
  }
  return 0;
}
