# For the page (emscripten): of the distribution's libraries it needs three that are headers only.
# They are linked one by one, because /usr/include itself would bring the C library's headers.

set(include ${CMAKE_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${include})
foreach(library glm stb toml++)
  if(NOT EXISTS /usr/include/${library})
    message(FATAL_ERROR "no /usr/include/${library}: run scripts/install_deps.sh scripts/packages_web.txt")
  endif()
  file(CREATE_LINK /usr/include/${library} ${include}/${library} SYMBOLIC)
endforeach()
foreach(library glm::glm tomlplusplus::tomlplusplus)
  add_library(${library} INTERFACE IMPORTED)
  target_include_directories(${library} SYSTEM INTERFACE ${include})
endforeach()
add_library(aucast_stb INTERFACE)
target_include_directories(aucast_stb SYSTEM INTERFACE ${include})

# One instruction set and one kind of exceptions for all objects; SIMD halves the time of a deform.
add_compile_options(-msimd128 -fwasm-exceptions)
add_link_options(-msimd128 -fwasm-exceptions)
