# SPDX-License-Identifier: Apache-2.0
# cmake --build build --target docs: the C++ interface and the pages of docs as one site, build/docs/html/index.html.
# Doxygen ends with an error where a link leads nowhere or a comment is not understood.
find_program(HANDSIGHT_DOXYGEN doxygen)
if(NOT HANDSIGHT_DOXYGEN OR NOT HANDSIGHT_HAS_LIBRARY)
  message(STATUS "The pages of docs are not made: doxygen is not there, or the library is not built.")
  return()
endif()
set(HANDSIGHT_PAGES ${CMAKE_BINARY_DIR}/docs)
set(HANDSIGHT_PUBLIC_HEADERS ${CMAKE_BINARY_DIR}/face/include)
configure_file(${CMAKE_SOURCE_DIR}/cmake/Doxyfile.in ${CMAKE_BINARY_DIR}/Doxyfile @ONLY)
file(MAKE_DIRECTORY ${HANDSIGHT_PAGES})
add_custom_target(docs COMMAND ${HANDSIGHT_DOXYGEN} ${CMAKE_BINARY_DIR}/Doxyfile DEPENDS handsight_public_headers VERBATIM)
