# What `cmake --install` puts where: programs, data, manual pages, completion, units of systemd.
# A component is the package that has it (aucast_package.cmake); `licences` is in none of them.

# aucast_install_program(NAME)
#   The program with what it says about itself: its manual page and what completes its options.
function(aucast_install_program name)
  set(page ${PROJECT_BINARY_DIR}/man/${name}.1)
  set(completion ${PROJECT_BINARY_DIR}/completion/${name})
  set(zsh ${PROJECT_BINARY_DIR}/completion/_${name})
  add_custom_command(
    OUTPUT ${page} ${completion} ${zsh} ${completion}.fish
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/man
            ${PROJECT_BINARY_DIR}/completion
    COMMAND ${name} --help-man > ${page}
    COMMAND ${name} --help-completion > ${completion}
    COMMAND ${name} --help-completion zsh > ${zsh}
    COMMAND ${name} --help-completion fish > ${completion}.fish
    DEPENDS ${name}
    COMMENT "Writing the manual page of ${name}")
  add_custom_target(${name}_manual ALL DEPENDS ${page} ${completion})
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${name})
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${name})
  install(FILES ${completion}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${name})
  install(FILES ${zsh}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT ${name})
  install(FILES ${completion}.fish
          DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT ${name})
endfunction()

# The models that read faces are Google's: a package has the script that fetches them instead.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/aucast
        COMPONENT aucast-data
        PATTERN CMakeLists.txt EXCLUDE PATTERN pictures EXCLUDE PATTERN models EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/models DESTINATION ${CMAKE_INSTALL_DATADIR}/aucast
        COMPONENT models OPTIONAL)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/protocol/PROTOCOL.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT aucast-data)
install(FILES ${PROJECT_SOURCE_DIR}/server/GUIDE.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT aucast-data RENAME au-transmitter.md)
install(FILES ${PROJECT_SOURCE_DIR}/client/GUIDE.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT aucast-data RENAME face-player.md)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licences)

# What scripts/build_web.sh has made, if it was run.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/build/web/page/
        DESTINATION ${CMAKE_INSTALL_DATADIR}/aucast/web COMPONENT aucast-web OPTIONAL)

if(TARGET face-player)
  aucast_install_program(face-player)
  install(FILES ${PROJECT_SOURCE_DIR}/client/view/fonts/LICENSE
          DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licences RENAME LICENSE.Inter)
  if(AUCAST_BUILD_RENDER)
    install(FILES ${PROJECT_SOURCE_DIR}/data/icons/aucast.png
            DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/256x256/apps
            COMPONENT face-player)
    install(FILES ${PROJECT_SOURCE_DIR}/data/icons/face-player.desktop
            DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT face-player)
  endif()
endif()
if(TARGET au-transmitter)
  aucast_install_program(au-transmitter)
  set(systemd ${PROJECT_SOURCE_DIR}/server/systemd)
  # Only the installation knows its prefix: `cmake --install --prefix` may change it.
  install(CODE "set(bindir ${CMAKE_INSTALL_BINDIR})
cmake_path(ABSOLUTE_PATH bindir BASE_DIRECTORY \"\${CMAKE_INSTALL_PREFIX}\")
set(units ${PROJECT_BINARY_DIR}/systemd)
configure_file(${systemd}/au-transmitter.service.in \${units}/au-transmitter.service @ONLY)
set(of_several \", %i of several\")
set(options \" --reuse-port --http 127.0.0.1:946%i\")
configure_file(${systemd}/au-transmitter.service.in \${units}/au-transmitter@.service @ONLY)"
          COMPONENT au-transmitter)
  install(FILES ${PROJECT_BINARY_DIR}/systemd/au-transmitter.service
                ${PROJECT_BINARY_DIR}/systemd/au-transmitter@.service
                ${systemd}/au-transmitter.socket
          DESTINATION lib/systemd/system COMPONENT au-transmitter)
  install(FILES ${systemd}/au-transmitter.toml
          DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT au-transmitter)
  install(PROGRAMS ${PROJECT_SOURCE_DIR}/scripts/install_models.sh
          DESTINATION ${CMAKE_INSTALL_DATADIR}/aucast/scripts COMPONENT au-transmitter)
endif()
if(TARGET aucast_nats)
  install(TARGETS aucast_nats LIBRARY DESTINATION ${AUCAST_MODULE_DIR} COMPONENT aucast-nats)
endif()
if(TARGET au-speaker)
  aucast_install_program(au-speaker)
endif()
