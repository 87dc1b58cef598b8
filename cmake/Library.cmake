# SPDX-License-Identifier: Apache-2.0
# What find_package(Handsight) finds: libhandsight.so, made of the folders of core that the face stands on, and the headers
# of core/include/handsight with those that they need below handsight/detail. Where code is position independent.
if(NOT HANDSIGHT_HAS_LIBRARY)
  return()
endif()

# handsight_parts_of(TARGET FOLDERS LIBRARIES): the folders of core that TARGET stands on, itself included, and the
# libraries of others that these use.
function(handsight_parts_of target folders libraries)
  set(todo ${target})
  set(mine)
  set(others)
  while(todo)
    list(POP_FRONT todo part)
    if(part IN_LIST mine)
      continue()
    endif()
    list(APPEND mine ${part})
    get_target_property(used ${part} LINK_LIBRARIES)
    foreach(name ${used})
      if(name MATCHES "^handsight_")
        list(APPEND todo ${name})
      else()
        list(APPEND others ${name})
      endif()
    endforeach()
  endwhile()
  list(REMOVE_DUPLICATES others)
  set(${folders} ${mine} PARENT_SCOPE)
  set(${libraries} ${others} PARENT_SCOPE)
endfunction()

include(GNUInstallDirs)
handsight_parts_of(handsight_face folders libraries)
set(objects)
foreach(folder ${folders})
  list(APPEND objects $<TARGET_OBJECTS:${folder}>)
endforeach()
add_library(handsight_shared SHARED ${objects})
add_library(Handsight::handsight ALIAS handsight_shared)
target_link_libraries(handsight_shared PRIVATE ${libraries} PUBLIC Eigen3::Eigen fmt::fmt tinyxml2::tinyxml2 Boost::headers)
target_link_options(handsight_shared PRIVATE -Wl,--no-undefined -Wl,--as-needed)
set_target_properties(handsight_shared PROPERTIES EXPORT_NAME handsight OUTPUT_NAME handsight LINKER_LANGUAGE CXX
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR} LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
target_compile_features(handsight_shared INTERFACE cxx_std_20)
add_dependencies(handsight_shared handsight_image_codec)

# The headers as they are installed: whatever changes in one of core, all are written again.
set(face ${CMAKE_BINARY_DIR}/face)
file(GLOB_RECURSE core_headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
add_custom_command(OUTPUT ${face}/written
  COMMAND ${CMAKE_COMMAND} -DCORE=${CMAKE_CURRENT_SOURCE_DIR} -DOUT=${face}/include -P ${CMAKE_SOURCE_DIR}/cmake/public_headers.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${face}/written
  DEPENDS ${core_headers} ${CMAKE_SOURCE_DIR}/cmake/public_headers.cmake VERBATIM)
add_custom_target(handsight_public_headers ALL DEPENDS ${face}/written)
target_include_directories(handsight_shared INTERFACE $<BUILD_INTERFACE:${face}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
add_dependencies(handsight_shared handsight_public_headers)
