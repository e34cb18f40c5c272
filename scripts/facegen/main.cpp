#include <cstdio>
#include <filesystem>

#include "common/files.h"
#include "scripts/facegen/head.h"

int main(int argument_count, char** arguments) {
  using namespace aucast;
  if (argument_count != 2) {
    std::fprintf(stderr, "usage: facegen FACE_FOLDER   (writes mesh.ply into it)\n");
    return exit_code({ErrorKind::Usage, {}});
  }
  const std::filesystem::path file = std::filesystem::path{arguments[1]} / "mesh.ply";
  const Result<void> written =
      write_file_atomically(file, facegen::head_file(facegen::make_head()));
  if (!written) {
    std::fprintf(stderr, "facegen: %s\n", written.error().message.c_str());
    return exit_code(written.error());
  }
  return 0;
}
