# One way to make each kind of target.

# aucast_library(NAME SOURCES a.cpp ... [LINK lib ...])
#   A static library; headers are included by their path from the project's root.
function(aucast_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ARG_LINK} PRIVATE aucast_warnings)
endfunction()

# aucast_program(NAME SOURCES main.cpp [LINK lib ...])
function(aucast_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} aucast_warnings)
  if(AUCAST_SANITIZER STREQUAL "thread")
    target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/scripts/cmake/first_blocking_call.cpp)
  endif()
endfunction()

# aucast_compile_quickly(NAME)
#   For tests, which are most of a build and most of which run once: -O3 took half as long again to
#   compile, -O1 with Clang's sanitizers more than twice as long as -O0.
function(aucast_compile_quickly name)
  # GCC 12 sees uninitialized members of any std::variant there.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${name} PRIVATE "$<$<CONFIG:Release>:-O1;-Wno-maybe-uninitialized>")
  elseif(NOT AUCAST_SANITIZER STREQUAL "none")
    target_compile_options(${name} PRIVATE -O0)
  endif()
endfunction()

# aucast_test(NAME SOURCES a_test.cpp ... [LINK lib ...] [LABELS unit] [TIMEOUT s])
#   A GoogleTest program, one entry of CTest. LABELS defaults to unit; tests that need OpenGL carry
#   gl, those that start programs, ffmpeg too, or take seconds carry integration.
function(aucast_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINK;LABELS" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  # The longest begin first, so that none runs alone at the end.
  set(cost ${ARG_TIMEOUT})
  if(AUCAST_SANITIZER STREQUAL "address")
    math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * 4")
  elseif(AUCAST_SANITIZER STREQUAL "thread")
    math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * 15")
  endif()
  aucast_program(${name} SOURCES ${ARG_SOURCES} LINK ${ARG_LINK} aucast_test_support
                 GTest::gtest_main)
  aucast_compile_quickly(${name})
  add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT}
                                          COST ${cost})
endfunction()

# aucast_embed(TARGET NAME FILE...)
#   Makes files part of a library: aucast::embedded::NAME() of common/embedded_file.h lists them.
function(aucast_embed target name)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${name}_embedded.cpp)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  add_custom_command(
    OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DNAME=${name} "-DFILES=${ARGN}"
            -P ${PROJECT_SOURCE_DIR}/scripts/cmake/embed.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/scripts/cmake/embed.cmake
    VERBATIM)
  # The linter reads sources that are not made yet.
  set_source_files_properties(${out} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${out})
endfunction()
