# Writes OUT, a C++ file with the bytes of FILES: cmake -DOUT=... -DNAME=... -DFILES=a;b -P embed.cmake
# It defines aucast::embedded::NAME(), which lists them by their file names.
set(entries "")
foreach(file IN LISTS FILES)
  file(READ ${file} bytes HEX)
  string(LENGTH "${bytes}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
  # In pieces: no compiler has to take a line of any length.
  string(REGEX REPLACE "(\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..)" "\\1\"\n    \""
         bytes "${bytes}")
  get_filename_component(file_name ${file} NAME)
  string(APPEND entries "    {\"${file_name}\", {\"${bytes}\", ${size}}},\n")
endforeach()
file(WRITE ${OUT} "#include \"common/embedded_file.h\"

namespace aucast::embedded {

std::span<const EmbeddedFile> ${NAME}() {
  static constexpr EmbeddedFile kFiles[] = {
${entries}  };
  return kFiles;
}

}  // namespace aucast::embedded
")
