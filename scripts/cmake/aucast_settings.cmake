# Language level, build type, warnings and sanitizers. Everything is carried by targets.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or RelWithDebInfo" FORCE)
endif()

find_program(AUCAST_CCACHE ccache)
if(AUCAST_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${AUCAST_CCACHE})
endif()

# All programs land beside data/ in the build folder, so that they find it.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
# Where installation puts things, below its prefix; what programs load is in a folder of its own.
include(GNUInstallDirs)
set(AUCAST_MODULE_DIR ${CMAKE_INSTALL_LIBDIR}/aucast)

add_library(aucast_warnings INTERFACE)
target_compile_options(aucast_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual
  # The same stream must give the same frames whatever the optimiser likes: no contraction into FMA.
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 sees overlaps in std::string's operator+ that are not there (its bug 105651).
  target_compile_options(aucast_warnings INTERFACE -Wno-restrict)
  if(CMAKE_UNITY_BUILD)
    # Sources included into one look like headers to it, where an unnamed namespace would be a fault.
    target_compile_options(aucast_warnings INTERFACE -Wno-subobject-linkage)
  endif()
endif()
if(EMSCRIPTEN)
  # size_t has 32 bits there, for what never was larger.
  target_compile_options(aucast_warnings INTERFACE -Wno-shorten-64-to-32 -Wno-sign-conversion)
endif()
if(AUCAST_WERROR)
  target_compile_options(aucast_warnings INTERFACE -Werror)
endif()

if(AUCAST_SANITIZER STREQUAL "address")
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-mismatched-new-delete -Wno-maybe-uninitialized)
  else()
    add_compile_options(-fno-sanitize=function)
  endif()
elseif(AUCAST_SANITIZER STREQUAL "thread")
  add_compile_options(-fsanitize=thread)
  add_link_options(-fsanitize=thread)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-tsan)
  endif()
elseif(NOT AUCAST_SANITIZER STREQUAL "none")
  message(FATAL_ERROR "AUCAST_SANITIZER is '${AUCAST_SANITIZER}'; use none, address or thread")
endif()
