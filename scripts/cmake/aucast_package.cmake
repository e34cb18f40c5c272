# `cpack -G DEB`: a Debian package of each component that aucast_install.cmake knows, with what a
# package has beside the files of `cmake --install`: changelog, copyright, compressed manual pages.

set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(AUCAST_PACKAGE_FOLDER ${PROJECT_BINARY_DIR}/package)
set(AUCAST_MAINTAINER "AUcast maintainers <maintainers@aucast.invalid>" CACHE STRING
    "Who answers for the packages: NAME <ADDRESS>")
# With SOURCE_DATE_EPOCH, as of the last commit, the same sources give the same packages.
string(TIMESTAMP AUCAST_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)

# aucast_write_copyright(NAME LICENCE_FILE... )
#   package/NAME/copyright: the given texts, one after the other; of a Debian package, named by what
#   it is compiled in as, the text that it has itself.
function(aucast_write_copyright name)
  set(text "")
  foreach(source IN LISTS ARGN)
    if(NOT IS_ABSOLUTE ${source})
      string(APPEND text "\n\n=== Compiled in: ${source}\n\n")
      set(source /usr/share/doc/${source}/copyright)
    endif()
    if(EXISTS ${source})
      file(READ ${source} part)
      string(APPEND text "${part}")
    endif()
  endforeach()
  file(WRITE ${AUCAST_PACKAGE_FOLDER}/${name}/copyright "${text}")
endfunction()

# aucast_package(NAME SUMMARY one line TEXT more [ALL] [SECTION s] [PART_OF p] [RECOMMENDS ...]
#                [SUGGESTS ...] [DEPENDS ...] [LICENCES file or Debian package...] [SCRIPTS file...])
#   The component NAME as a package of that name, which depends on PART_OF (default: aucast-data) of
#   the same version. ALL: of no architecture; others depend on the libraries they are linked with.
function(aucast_package name)
  cmake_parse_arguments(ARG "ALL" "SUMMARY;TEXT;SECTION;PART_OF"
                        "DEPENDS;RECOMMENDS;SUGGESTS;LICENCES;SCRIPTS" ${ARGN})
  string(TOUPPER ${name} upper)
  set(folder ${AUCAST_PACKAGE_FOLDER}/${name})
  aucast_write_copyright(${name} ${PROJECT_SOURCE_DIR}/LICENSE ${ARG_LICENCES})
  configure_file(${PROJECT_SOURCE_DIR}/scripts/package/changelog.in ${folder}/changelog.Debian)
  install(FILES ${folder}/copyright ${folder}/changelog.Debian
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${name} EXCLUDE_FROM_ALL)
  install(CODE "set(share \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\")
file(GLOB pages \${share}/man/man1/*.1)
execute_process(COMMAND gzip -9nf \${pages} \${share}/doc/${name}/changelog.Debian
                COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${name} EXCLUDE_FROM_ALL)

  set(variable CPACK_DEBIAN_${upper}_PACKAGE)
  set(${variable}_NAME ${name} PARENT_SCOPE)
  set(${variable}_SHLIBDEPS ON PARENT_SCOPE)
  if(ARG_ALL)
    set(${variable}_ARCHITECTURE all PARENT_SCOPE)
    set(${variable}_SHLIBDEPS OFF PARENT_SCOPE)
  endif()
  if(NOT ARG_PART_OF AND NOT name STREQUAL aucast-data)
    set(ARG_PART_OF aucast-data)
  endif()
  set(CPACK_COMPONENT_${upper}_DEPENDS ${ARG_PART_OF} PARENT_SCOPE)
  foreach(field DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN ARG_${field} ", " packages)
    set(${variable}_${field} "${packages}" PARENT_SCOPE)
  endforeach()
  set(${variable}_SECTION ${ARG_SECTION} PARENT_SCOPE)
  set(${variable}_CONTROL_EXTRA ${ARG_SCRIPTS} PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${ARG_SUMMARY}\n${ARG_TEXT}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${name} PARENT_SCOPE)
endfunction()

set(packaging ${PROJECT_SOURCE_DIR}/scripts/package)
aucast_package(aucast-data ALL SECTION video
  SUMMARY "faces, rules, expressions and streams of AUcast"
  TEXT "AUcast sends a human face over a thin wire as FACS Action Units. These are the\nfiles that both its programs read, and how it speaks on the wire.")
if(TARGET au-transmitter)
  aucast_package(au-transmitter SECTION net
    SUMMARY "streams faces as FACS Action Units"
    TEXT "Serves stream files, recordings of AU recognisers, cameras and streams of other\nau-transmitters to any number of clients: face-player, browsers, one's own.\nThe service is started by the operator, who first names what it serves."
    RECOMMENDS ffmpeg SUGGESTS aucast-nats aucast-web face-player npm
    LICENCES libasio-dev nlohmann-json3-dev libcli11-dev
    SCRIPTS ${packaging}/postinst ${packaging}/prerm ${packaging}/postrm)
endif()
if(TARGET aucast_nats)
  aucast_package(aucast-nats SECTION net PART_OF au-transmitter
    SUMMARY "streams of AUcast over NATS"
    TEXT "What au-transmitter loads to publish a stream over servers of NATS, or to\nfollow one there: addresses nats:// and natss://."
    SUGGESTS nats-server)
endif()
if(TARGET face-player)
  aucast_package(face-player SECTION video
    SUMMARY "draws a face that comes as FACS Action Units"
    TEXT "Receives what au-transmitter serves, or reads its files, and shows it on a face\nof muscles: in a window, as video, pictures, glTF files or numbers."
    DEPENDS libegl1 libgl1 RECOMMENDS ffmpeg libgl1-mesa-dri fonts-inter SUGGESTS au-transmitter
    LICENCES ${PROJECT_SOURCE_DIR}/client/view/fonts/LICENSE libasio-dev nlohmann-json3-dev
             libcli11-dev libglm-dev libimgui-dev)
endif()
if(TARGET au-speaker)
  aucast_package(au-speaker SECTION sound
    SUMMARY "makes faces speak, from a text or a recorded voice"
    TEXT "Turns a text into speech, a stream file for au-transmitter and captions, or a\nrecorded voice with its transcript into a face that speaks it."
    SUGGESTS au-transmitter
    LICENCES ${packaging}/speaker_licence.txt libcli11-dev)
endif()
if(EXISTS ${PROJECT_SOURCE_DIR}/build/web/page/index.html)
  aucast_package(aucast-web ALL SECTION web
    SUMMARY "player of AUcast streams as a web page"
    TEXT "What au-transmitter --web serves: face-player, compiled for browsers. It needs\nno installation there."
    SUGGESTS au-transmitter
    LICENCES ${PROJECT_SOURCE_DIR}/client/web/opus_decoder_licence.txt libglm-dev emscripten)
endif()

set(CPACK_PACKAGE_NAME aucast)
set(CPACK_PACKAGE_VENDOR AUcast)
set(CPACK_PACKAGE_CONTACT "${AUCAST_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
include(CPack)
