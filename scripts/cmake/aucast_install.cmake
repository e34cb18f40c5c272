# What `cmake --install` puts where: programs, data, manual pages, completion, units of systemd.

include(GNUInstallDirs)

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
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${completion}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${zsh} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES ${completion}.fish
          DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endfunction()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/aucast
        PATTERN CMakeLists.txt EXCLUDE PATTERN pictures EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/LICENSE
              ${PROJECT_SOURCE_DIR}/protocol/PROTOCOL.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})

# What scripts/build_web.sh has made, if it was run.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/build/web/page/
        DESTINATION ${CMAKE_INSTALL_DATADIR}/aucast/web OPTIONAL)

if(TARGET face-player)
  aucast_install_program(face-player)
  install(FILES ${PROJECT_SOURCE_DIR}/client/view/fonts/LICENSE
          DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE.Inter)
  if(AUCAST_BUILD_RENDER)
    install(FILES ${PROJECT_SOURCE_DIR}/data/icons/aucast.png
            DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/256x256/apps)
    install(FILES ${PROJECT_SOURCE_DIR}/data/icons/face-player.desktop
            DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  endif()
endif()
if(TARGET au-transmitter)
  aucast_install_program(au-transmitter)
  set(systemd ${PROJECT_SOURCE_DIR}/server/systemd)
  # Only the installation knows its prefix: `cmake --install --prefix` may change it.
  install(CODE "set(bindir ${CMAKE_INSTALL_BINDIR})
cmake_path(ABSOLUTE_PATH bindir BASE_DIRECTORY \"\${CMAKE_INSTALL_PREFIX}\")
configure_file(${systemd}/au-transmitter.service.in
               ${PROJECT_BINARY_DIR}/systemd/au-transmitter.service @ONLY)")
  install(FILES ${PROJECT_BINARY_DIR}/systemd/au-transmitter.service
                ${systemd}/au-transmitter.socket
          DESTINATION lib/systemd/system)
  install(FILES ${systemd}/au-transmitter.toml DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
