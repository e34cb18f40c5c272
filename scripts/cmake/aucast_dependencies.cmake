# Everything from the distribution, nothing downloaded. The names of the packages are in
# scripts/packages.txt; scripts/install_deps.sh installs them.

find_package(Threads REQUIRED)

# Asio is header-only and ships neither a CMake package nor a .pc file. Compiled once instead, it
# shortens the compilation of what includes it by a tenth and costs a tenth of the fan-out: that is
# for the sanitizers.
find_path(AUCAST_ASIO_INCLUDE_DIR asio.hpp REQUIRED)
# Asio chooses its allocator by what the standard library has defined by then, so that comes first,
# as it does in every other source.
file(CONFIGURE OUTPUT asio.cpp CONTENT "#include <cstdlib>\n#include <asio/impl/src.hpp>\n")
if(AUCAST_SANITIZER STREQUAL "none")
  set(asio_scope INTERFACE)
  add_library(aucast_asio INTERFACE)
else()
  set(asio_scope PUBLIC)
  add_library(aucast_asio STATIC ${CMAKE_CURRENT_BINARY_DIR}/asio.cpp)
  target_compile_definitions(aucast_asio PUBLIC ASIO_SEPARATE_COMPILATION)
endif()
target_include_directories(aucast_asio SYSTEM ${asio_scope} ${AUCAST_ASIO_INCLUDE_DIR})
target_compile_definitions(aucast_asio ${asio_scope} ASIO_STANDALONE ASIO_NO_DEPRECATED)
target_link_libraries(aucast_asio ${asio_scope} Threads::Threads)

find_package(OpenSSL 3.0 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(opus REQUIRED IMPORTED_TARGET opus)
pkg_check_modules(ogg REQUIRED IMPORTED_TARGET ogg)
pkg_check_modules(sndfile REQUIRED IMPORTED_TARGET sndfile)
pkg_check_modules(mpg123 REQUIRED IMPORTED_TARGET libmpg123)
pkg_check_modules(samplerate REQUIRED IMPORTED_TARGET samplerate)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)

# For the module by which au-transmitter speaks NATS; without it the program says what is missing.
pkg_check_modules(nats QUIET IMPORTED_TARGET libnats)
option(AUCAST_NATS "Build aucast-nats.so, NATS for au-transmitter (libnats)" ${nats_FOUND})
if(AUCAST_NATS AND NOT nats_FOUND)
  message(FATAL_ERROR "AUCAST_NATS needs libnats: scripts/install_deps.sh scripts/packages_nats.txt")
endif()

if(AUCAST_BUILD_CLIENT)
  find_package(glm REQUIRED)
  pkg_check_modules(openal REQUIRED IMPORTED_TARGET openal)
endif()
if(AUCAST_BUILD_CLIENT AND AUCAST_BUILD_RENDER)
  find_package(glfw3 3.3 REQUIRED)
  pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
  # libimgui.a needs libstb, which is why the order of its .pc file must stay.
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
endif()
if(AUCAST_BUILD_CLIENT)
  find_path(AUCAST_STB_INCLUDE_DIR stb/stb_image_write.h REQUIRED)
  add_library(aucast_stb INTERFACE)
  target_include_directories(aucast_stb SYSTEM INTERFACE ${AUCAST_STB_INCLUDE_DIR})
endif()
if(AUCAST_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()
