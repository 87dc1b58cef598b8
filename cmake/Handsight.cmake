# SPDX-License-Identifier: Apache-2.0
# How every target of the project is made: same warnings, same sanitizers, one library per folder.

find_program(HANDSIGHT_CCACHE ccache)
if(HANDSIGHT_CCACHE)
  # Sloppiness: what a cache must overlook to know precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${HANDSIGHT_CCACHE})
endif()
# Most of what is left of a compiler's time goes into instantiating the same templates in source after source: the sources
# of a room are compiled as one, which takes a third less. While one room is worked on, -DHANDSIGHT_JOINED=OFF compiles less
# after a change. Sources of one room must not give the same name to different things, not in unnamed namespaces either.
option(HANDSIGHT_JOINED "Compile the sources of a room together" ON)

add_compile_options(-Wall -Wextra -Wnon-virtual-dtor -Wno-unused-parameter
  $<$<NOT:$<BOOL:${HANDSIGHT_JOINED}>>:-Wshadow>  # of joined sources one may use a name of another's unnamed namespace
  -Wno-missing-field-initializers  # designated initialisers name what they set
  # False alarms of GCC 12 on std::string and on Eigen's memory.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow> $<$<CXX_COMPILER_ID:GNU>:-Wno-use-after-free>)
# Binaries must give the same result on every x86-64: no contraction, no -march=native.
add_compile_options(-ffp-contract=off)
# With large precompiled headers GCC would spend a fifth of its time on looking for what it can free.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=400000>)
if(HANDSIGHT_SANITIZE)
  add_compile_options(-fsanitize=${HANDSIGHT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined -g1)
  # The sanitizers call dlopen in our place: the run path must be the program's, which holds for every caller.
  add_link_options(-fsanitize=${HANDSIGHT_SANITIZE} -Wl,--disable-new-dtags)
endif()
option(HANDSIGHT_COVERAGE "Count which lines the tests run (clang; cmake/coverage.sh)" OFF)
if(HANDSIGHT_COVERAGE)
  add_compile_options(-fprofile-instr-generate -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
endif()
if(HANDSIGHT_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "HANDSIGHT_FUZZ needs clang (libFuzzer): -DCMAKE_CXX_COMPILER=clang++, or the preset fuzz.")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# Most of a compiler's time went into reading the same headers and instantiating the same templates of Eigen again: they
# are precompiled, in three sets, each for what stands above the last one. A source still includes what it uses. A header
# belongs in a set if most of the sources that use the set include it.
option(HANDSIGHT_PRECOMPILED "Precompile headers that most sources read" ON)
set(core ${CMAKE_CURRENT_LIST_DIR}/../core)
set(handsight_headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <numeric> <optional> <random> <set> <span>
  <string> <string_view> <vector> <fmt/format.h> <Eigen/Dense>
  "${core}/geometry/compiled_once.h" "${core}/geometry/rigid.h"  # what uses them must link handsight_geometry
  "${core}/base/error.h" "${core}/base/message.h" "${core}/base/bounds.h" "${core}/base/text.h")
set(handsight_model_headers ${handsight_headers} <boost/container/small_vector.hpp>
  "${core}/session/session.h" "${core}/chain/chain.h" "${core}/chain/sighting.h" "${core}/effects/effect.h")
set(handsight_fit_headers ${handsight_model_headers} "${core}/base/threads.h" "${core}/estimation/problem/problem.h"
  "${core}/estimation/fit/fit.h" "${core}/diagnosis/evidence/evidence.h")

# handsight_precompile(NAME HEADERS ... LINK LIBRARY ...): a set of precompiled headers that targets share.
function(handsight_precompile name)
  cmake_parse_arguments(arg "" "" "HEADERS;LINK" ${ARGN})
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp CONTENT "// Holds nothing but the precompiled headers.\n")
  add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${arg_LINK})
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/core)
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

# handsight_use_headers(TARGET NAME): TARGET is compiled with the set NAME.
function(handsight_use_headers target name)
  if(HANDSIGHT_PRECOMPILED)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()

# handsight_join(TARGET [APART ROOM ...]): the sources of each folder of TARGET are compiled as one, twelve at most, but for
# those of the rooms, and the sources, that stand APART.
function(handsight_join target)
  cmake_parse_arguments(arg "" "" "APART" ${ARGN})
  if(NOT HANDSIGHT_JOINED)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(path ${source} ABSOLUTE)
    get_filename_component(room ${path} DIRECTORY)
    file(RELATIVE_PATH path ${CMAKE_CURRENT_SOURCE_DIR} ${path})
    file(RELATIVE_PATH room ${CMAKE_CURRENT_SOURCE_DIR} ${room})
    if(source MATCHES "\\.cpp$" AND NOT room IN_LIST arg_APART AND NOT path IN_LIST arg_APART)
      string(MAKE_C_IDENTIFIER "in_${room}" room)
      list(APPEND ${room}_joined ${source})
      list(LENGTH ${room}_joined part)
      math(EXPR part "(${part} - 1) / 12")
      set_property(SOURCE ${source} TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP "${room}_${part}")
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# handsight_library(NAME [folders and libraries that it uses ...]): the .cpp files of the folder and its rooms as target
# handsight_NAME, compiled with the set of headers that the variable handsight_headers_of names.
function(handsight_library name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*/*.cpp)
  if(sources)
    add_library(handsight_${name} STATIC ${sources})
    target_include_directories(handsight_${name} PUBLIC ${CMAKE_SOURCE_DIR}/core)
    target_link_libraries(handsight_${name} PUBLIC ${ARGN})
    if(NOT name STREQUAL "base")  # the only one without Eigen
      handsight_use_headers(handsight_${name} ${handsight_headers_of})
    endif()
    handsight_join(handsight_${name} APART ${handsight_rooms_apart})
  else()
    add_library(handsight_${name} INTERFACE)
    target_include_directories(handsight_${name} INTERFACE ${CMAKE_SOURCE_DIR}/core)
    target_link_libraries(handsight_${name} INTERFACE ${ARGN})
  endif()
endfunction()
