# SPDX-License-Identifier: Apache-2.0
# cmake --install, and with cpack two Debian packages: handsight-cli (no Qt, no VTK) and handsight, the window, which
# needs the first.
include(GNUInstallDirs)

set(codec_folder ${CMAKE_INSTALL_LIBEXECDIR}/handsight)  # what programs load when it is first needed
file(RELATIVE_PATH codec_from_bin ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBEXECDIR}/handsight)
set_target_properties(handsight-cli handsight-driver-simulated PROPERTIES INSTALL_RPATH "$ORIGIN/${codec_from_bin}")
install(TARGETS handsight-cli handsight-driver-simulated RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT cli)
install(TARGETS handsight_image_codec LIBRARY DESTINATION ${codec_folder} COMPONENT cli)

# Manual page and completions, from the command line's own description.
set(described ${CMAKE_BINARY_DIR}/described)
set(described_files)
foreach(what man bash zsh fish)
  add_custom_command(OUTPUT ${described}/${what}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${described}
    COMMAND handsight-cli describe ${what} > ${described}/${what}
    DEPENDS handsight-cli VERBATIM)
  list(APPEND described_files ${described}/${what})
endforeach()
# As Debian wants them: compressed, the same bytes from every build.
find_program(HANDSIGHT_GZIP gzip REQUIRED)
function(compressed source name)
  add_custom_command(OUTPUT ${described}/${name} COMMAND ${CMAKE_COMMAND} -E make_directory ${described}
    COMMAND ${HANDSIGHT_GZIP} -9nc ${source} > ${described}/${name} DEPENDS ${source} VERBATIM)
endfunction()
compressed(${described}/man handsight-cli.1.gz)
compressed(${CMAKE_SOURCE_DIR}/CHANGELOG.md NEWS.gz)
# Debian's own is of its form; what has changed for users is in NEWS.
foreach(package handsight handsight-cli)
  file(CONFIGURE OUTPUT ${described}/${package}.changelog CONTENT
    "${package} (@PROJECT_VERSION@) unstable; urgency=medium\n\n  * Built from source; see NEWS.gz.\n\n -- The Handsight developers <maintainers@handsight.invalid>  Sat, 01 Jan 2000 00:00:00 +0000\n" @ONLY)
  compressed(${described}/${package}.changelog ${package}.changelog.gz)
endforeach()
compressed(${CMAKE_SOURCE_DIR}/resources/handsight.1 handsight.1.gz)
add_custom_target(describe ALL DEPENDS ${described_files} ${described}/handsight-cli.1.gz ${described}/NEWS.gz
  ${described}/handsight.1.gz ${described}/handsight.changelog.gz ${described}/handsight-cli.changelog.gz)
install(FILES ${described}/handsight-cli.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT cli)
install(FILES ${described}/bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME handsight-cli
  COMPONENT cli)
install(FILES ${described}/zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions RENAME _handsight-cli COMPONENT cli)
install(FILES ${described}/fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d RENAME handsight-cli.fish
  COMPONENT cli)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}-cli COMPONENT cli
  FILES_MATCHING PATTERN "*.md" PATTERN "drivers/*.py" PATTERN pictures EXCLUDE PATTERN "examples/cpp" EXCLUDE PATTERN "examples/python" EXCLUDE)
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${described}/NEWS.gz DESTINATION ${CMAKE_INSTALL_DOCDIR}-cli COMPONENT cli)
install(FILES ${described}/handsight-cli.changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR}-cli RENAME changelog.gz COMPONENT cli)
install(FILES ${CMAKE_SOURCE_DIR}/resources/debian/copyright_cli DESTINATION ${CMAKE_INSTALL_DOCDIR}-cli RENAME copyright
  COMPONENT cli)
install(FILES ${CMAKE_SOURCE_DIR}/resources/justin.urdf DESTINATION ${CMAKE_INSTALL_DATADIR}/handsight/robots COMPONENT cli)

# cmake --install build --component development: the library, its headers, and what find_package(Handsight) reads.
if(HANDSIGHT_HAS_LIBRARY)
  include(CMakePackageConfigHelpers)
  set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Handsight)
  file(RELATIVE_PATH codec_from_lib ${CMAKE_INSTALL_FULL_LIBDIR} ${CMAKE_INSTALL_FULL_LIBEXECDIR}/handsight)
  set_target_properties(handsight_shared PROPERTIES BUILD_RPATH "$ORIGIN" INSTALL_RPATH "$ORIGIN/${codec_from_lib}")
  install(TARGETS handsight_shared EXPORT Handsight LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(TARGETS handsight_image_codec LIBRARY DESTINATION ${codec_folder} COMPONENT development)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/face/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  install(EXPORT Handsight NAMESPACE Handsight:: FILE HandsightTargets.cmake DESTINATION ${package_folder} COMPONENT development)
  configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/HandsightConfig.cmake.in ${CMAKE_BINARY_DIR}/HandsightConfig.cmake
    INSTALL_DESTINATION ${package_folder})
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/HandsightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_BINARY_DIR}/HandsightConfig.cmake ${CMAKE_BINARY_DIR}/HandsightConfigVersion.cmake
    DESTINATION ${package_folder} COMPONENT development)
endif()

if(HANDSIGHT_HAS_WINDOW)
  set_target_properties(handsight PROPERTIES INSTALL_RPATH "$ORIGIN/${codec_from_bin}")
  install(TARGETS handsight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT window)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/handsight.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT window)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/handsight.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps
    COMPONENT window)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/handsight-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
    RENAME handsight.xml COMPONENT window)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/handsight.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT window)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/debian/copyright_window DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright
    COMPONENT window)
  install(FILES ${described}/handsight.changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME changelog.gz COMPONENT window)
  install(FILES ${described}/handsight.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT window)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/sample_sessions/ DESTINATION ${CMAKE_INSTALL_DATADIR}/handsight/sample_sessions
    COMPONENT window PATTERN "*.sh" EXCLUDE PATTERN make EXCLUDE)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME handsight)
set(CPACK_PACKAGE_CONTACT "The Handsight developers <maintainers@handsight.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Robot hand-eye calibration that says why the hand is elsewhere")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL cli)
if(HANDSIGHT_HAS_WINDOW)
  list(APPEND CPACK_COMPONENTS_ALL window)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS  # whatever the umask
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_CLI_PACKAGE_NAME handsight-cli)
set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME handsight)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "handsight-cli (= ${PROJECT_VERSION}), libqt6svg6")
set(CPACK_COMPONENT_CLI_DESCRIPTION "Command line of Handsight: fit, diagnose, correct, export. No display needed.")
set(CPACK_COMPONENT_WINDOW_DESCRIPTION "Window of Handsight: label, calibrate, inspect, explain and export.")
include(CPack)
