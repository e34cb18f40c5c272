#include <cstdio>
#include <filesystem>

#include "common/files.h"
#include "scripts/facegen/head.h"
#include "scripts/facegen/identity.h"

int main(int argument_count, char** arguments) {
  using namespace aucast;
  if (argument_count != 2 && argument_count != 3) {
    std::fprintf(stderr, "usage: facegen FACE_FOLDER [IDENTITY]   (writes mesh.ply into it)\n");
    return exit_code({ErrorKind::Usage, {}});
  }
  const std::filesystem::path file = std::filesystem::path{arguments[1]} / "mesh.ply";
  std::vector<facegen::Part> head = facegen::make_head();
  if (argument_count == 3) {
    const auto identity = facegen::identity_named(arguments[2]);
    if (!identity) {
      std::fprintf(stderr, "facegen: no identity of that name; see identity.cpp\n");
      return exit_code({ErrorKind::Usage, {}});
    }
    facegen::apply(*identity, head);
  }
  const Result<void> written = write_file_atomically(file, facegen::head_file(head));
  if (!written) {
    std::fprintf(stderr, "facegen: %s\n", written.error().message.c_str());
    return exit_code(written.error());
  }
  return 0;
}
