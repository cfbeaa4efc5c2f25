# The compiler's settings, the same for every target.

option(GEARGRAPH_QT "Build the layers, programs and tests that need Qt" ON)
option(GEARGRAPH_WERROR "Warnings are errors (on in CI, off on users' machines)" OFF)
option(GEARGRAPH_UNITY "Compile the sources of a layer together, and the tests of a group: half the time for all, more for one" OFF)
option(GEARGRAPH_PYTHON "Build the Python module" ON)
if(CMAKE_SYSTEM_NAME STREQUAL Linux)
  set(portable OFF)
else()
  set(portable ON)
endif()
option(GEARGRAPH_PORTABLE "Make do with the standard library where there are calls of Linux (core/foundations/platform)" ${portable})
option(GEARGRAPH_GRAPHVIZ "Lay digraphs out by Graphviz; without it by the tree of the turning joints" ON)
option(GEARGRAPH_STEP "Build geargraph-step, where OpenCASCADE is" ON)
set(GEARGRAPH_SANITIZE "" CACHE STRING "Sanitizers, comma separated (address,undefined or thread)")
# Sanitizers bring an allocator of their own.
include(CMakeDependentOption)
cmake_dependent_option(GEARGRAPH_JEMALLOC "The editor allocates with jemalloc (app/editor/memory.cpp)" ON
  "GEARGRAPH_QT;NOT GEARGRAPH_PORTABLE;NOT GEARGRAPH_SANITIZE" OFF)

option(GEARGRAPH_FUZZ "Build the libFuzzer programs (clang only; preset fuzz)" OFF)

option(GEARGRAPH_LIBCXX "Build with LLVM's C++ library (clang only; preset libcxx)" OFF)
if(GEARGRAPH_LIBCXX)
  # Stop tokens are experimental before its version 20.
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-stdlib=libc++> $<$<COMPILE_LANGUAGE:CXX>:-fexperimental-library>)
  add_link_options(-stdlib=libc++ -fexperimental-library)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(geargraph_warnings INTERFACE)
if(MSVC)   # not tried yet (docs/ports.md)
  add_compile_options(/utf-8 /permissive- /Zc:__cplusplus)
  add_compile_definitions(NOMINMAX _USE_MATH_DEFINES)
  target_compile_options(geargraph_warnings INTERFACE /W4)
else()
  target_compile_options(geargraph_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
endif()
target_compile_options(geargraph_warnings INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>   # GCC 12 misreads std::string concatenation (its bug 105651)
  # In unity builds GCC takes what a source keeps to itself for what a header hands out.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${GEARGRAPH_UNITY}>>:-Wno-subobject-linkage>
  $<$<BOOL:${GEARGRAPH_WERROR}>:$<IF:$<CXX_COMPILER_ID:MSVC>,/WX,-Werror>>)

if(GEARGRAPH_SANITIZE)
  set(GEARGRAPH_PYTHON OFF)   # the interpreter is not built with them
  add_compile_options(-fsanitize=${GEARGRAPH_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${GEARGRAPH_SANITIZE})
endif()

# moc 6.4 stops with «Parse error at "std"» when a header reaches <compare> first; cured in Qt 6.5.3.
set(CMAKE_AUTOMOC_MOC_OPTIONS -D_GLIBCXX_VISIBILITY=)

find_program(GEARGRAPH_CCACHE ccache)
if(GEARGRAPH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Paths are hashed relative to the checkout, so that two checkouts share their results.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros ${GEARGRAPH_CCACHE})
  # Without it GCC does not name the compiled headers that it reads.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

find_program(GEARGRAPH_MOLD mold)
if(GEARGRAPH_MOLD AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT GEARGRAPH_FUZZ)
  add_link_options(-fuse-ld=mold)
endif()
