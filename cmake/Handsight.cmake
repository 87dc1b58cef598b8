# SPDX-License-Identifier: Apache-2.0
# How every target of the project is made: same warnings, same sanitizers, one library per folder.

find_program(HANDSIGHT_CCACHE ccache)
if(HANDSIGHT_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${HANDSIGHT_CCACHE})
endif()
find_program(HANDSIGHT_MOLD mold)
if(HANDSIGHT_MOLD)
  add_link_options(-fuse-ld=mold)
endif()
add_compile_options(-Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wno-unused-parameter
  -Wno-missing-field-initializers  # designated initialisers name what they set
  -Wno-restrict)                   # false alarms of GCC 12 on std::string
# Binaries must give the same result on every x86-64: no contraction, no -march=native.
add_compile_options(-ffp-contract=off)
if(HANDSIGHT_SANITIZE)
  add_compile_options(-fsanitize=${HANDSIGHT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined -g1)
  # The sanitizers call dlopen in our place: the run path must be the program's, which holds for every caller.
  add_link_options(-fsanitize=${HANDSIGHT_SANITIZE} -Wl,--disable-new-dtags)
endif()
if(HANDSIGHT_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "HANDSIGHT_FUZZ needs clang (libFuzzer): -DCMAKE_CXX_COMPILER=clang++, or the preset fuzz.")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# handsight_library(NAME [folders and libraries that it uses ...]): the folder's .cpp files as target handsight_NAME.
function(handsight_library name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(sources)
    add_library(handsight_${name} STATIC ${sources})
    target_include_directories(handsight_${name} PUBLIC ${CMAKE_SOURCE_DIR}/core)
    target_link_libraries(handsight_${name} PUBLIC ${ARGN})
  else()
    add_library(handsight_${name} INTERFACE)
    target_include_directories(handsight_${name} INTERFACE ${CMAKE_SOURCE_DIR}/core)
    target_link_libraries(handsight_${name} INTERFACE ${ARGN})
  endif()
endfunction()
