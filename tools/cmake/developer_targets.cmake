# Targets instead of scripts: cmake --build --preset release --target format | format-check | tidy | api

find_program(GEARGRAPH_CLANG_FORMAT NAMES clang-format-14 clang-format)
find_program(GEARGRAPH_RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)
file(GLOB_RECURSE geargraph_sources CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/app/*.cpp ${PROJECT_SOURCE_DIR}/app/*.h
  ${PROJECT_SOURCE_DIR}/core/*.cpp ${PROJECT_SOURCE_DIR}/core/*.h
  ${PROJECT_SOURCE_DIR}/ui/*.cpp ${PROJECT_SOURCE_DIR}/ui/*.h
  ${PROJECT_SOURCE_DIR}/resources/library_example/*.cpp
  ${PROJECT_SOURCE_DIR}/tests/*.cpp ${PROJECT_SOURCE_DIR}/tests/*.h)

if(GEARGRAPH_CLANG_FORMAT)
  add_custom_target(format COMMAND ${GEARGRAPH_CLANG_FORMAT} -i ${geargraph_sources} VERBATIM)
  add_custom_target(format-check COMMAND ${GEARGRAPH_CLANG_FORMAT} --dry-run -Werror ${geargraph_sources} VERBATIM)
endif()
if(GEARGRAPH_RUN_CLANG_TIDY)
  add_custom_target(tidy COMMAND ${GEARGRAPH_RUN_CLANG_TIDY} -quiet -p ${CMAKE_BINARY_DIR}
    "${PROJECT_SOURCE_DIR}/(app|core|ui)/" VERBATIM)
endif()

find_program(GEARGRAPH_DOXYGEN doxygen)
if(GEARGRAPH_DOXYGEN)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${CMAKE_BINARY_DIR}/Doxyfile @ONLY)
  add_custom_target(api COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/api
    COMMAND ${GEARGRAPH_DOXYGEN} ${CMAKE_BINARY_DIR}/Doxyfile VERBATIM)
endif()
