#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include "common/files.h"
#include "common/number_of.h"
#include "common/text.h"
#include "scripts/facegen/head.h"
#include "scripts/facegen/variation.h"

namespace {

using namespace aucast;

constexpr const char* kUsage =
    "usage: facegen FACE_FOLDER [PERSON [NUMBER]]\n"
    "Makes the head of PERSON and writes it as mesh.ply into FACE_FOLDER.\n"
    "PERSON: a name in scripts/facegen/people, or a file like those, FILE.toml (default)\n"
    "NUMBER: somebody else who looks a little like PERSON; 0 is PERSON";

Result<facegen::Identity> person_of(const std::string& person, const std::string& number) {
  const bool is_file = person.ends_with(".toml");
  auto who = is_file ? facegen::read_identity(person) : facegen::identity_named(person);
  if (!who) return who;
  const auto which = number_of<std::uint32_t>(number);
  if (!which) {
    return Error{ErrorKind::Usage, "'" + number + "' is not a whole number from 0 on"};
  }
  if (*which == 0) return who;
  if (who->varies_towards.empty()) {
    return Error{ErrorKind::Usage,
                 "NUMBER wants 'varies_towards' in the file of '" + escaped(person) + "'"};
  }
  const auto other = facegen::identity_named(who->varies_towards);
  if (!other) return other;
  return facegen::varied(*who, *other, *which);
}

Result<void> run(std::span<char*> arguments) {
  const auto person = person_of(arguments.size() > 1 ? arguments[1] : "default",
                                arguments.size() > 2 ? arguments[2] : "0");
  if (!person) return person.error();
  const auto head = facegen::make_head(*person);
  if (!head) return head.error();
  return write_file_atomically(std::filesystem::path{arguments[0]} / "mesh.ply",
                               facegen::head_file(*head));
}

}  // namespace

int main(int argument_count, char** arguments) {
  const auto words = std::span(arguments, static_cast<std::size_t>(argument_count)).subspan(1);
  if (words.size() == 1 &&
      (words[0] == std::string_view("--help") || words[0] == std::string_view("-h"))) {
    std::puts(kUsage);
    return 0;
  }
  if (words.empty() || words.size() > 3) {
    std::fprintf(stderr, "%s\n", kUsage);
    return static_cast<int>(ErrorKind::Usage);
  }
  try {
    const Result<void> written = run(words);
    if (written) return 0;
    std::fprintf(stderr, "facegen: %s\n", written.error().message.c_str());
    return exit_code(written.error());
  } catch (const std::bad_alloc&) {
    std::fputs("facegen: there is not enough memory left to go on\n", stderr);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "facegen: stopped by an unexpected failure: %s\n", failure.what());
  }
  return 1;
}
