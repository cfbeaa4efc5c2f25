# Layers: one folder below core/ or ui/ = one static library = one layer.

set_property(GLOBAL PROPERTY GEARGRAPH_LAYERS "")

# geargraph_layer(name SOURCES files... [ALONE files...] [USES layers...] [QT modules...] [EXTERNAL targets...])
#
# Makes the static library geargraph_<name> from the files of this folder. USES names the layers it may include
# from and is linked publicly; it is the only place a dependency between layers is written. The test
# quality.layering reads the same list. QT turns on moc and Qt's include paths; a layer without QT cannot
# include a Qt header, because no such path reaches its compiler. ALONE: sources whose local names others of the layer
# have, too; unity builds (GEARGRAPH_UNITY) compile them by themselves.
function(geargraph_layer name)
  cmake_parse_arguments(LAYER "" "" "SOURCES;ALONE;USES;QT;EXTERNAL" ${ARGN})
  if(LAYER_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "geargraph_layer(${name}): unknown arguments ${LAYER_UNPARSED_ARGUMENTS}")
  endif()
  set(library geargraph_${name})
  add_library(${library} STATIC ${LAYER_SOURCES})
  target_include_directories(${library} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${library} PRIVATE geargraph_warnings)
  foreach(used IN LISTS LAYER_USES)
    target_link_libraries(${library} PUBLIC geargraph_${used})
  endforeach()
  target_link_libraries(${library} PUBLIC ${LAYER_EXTERNAL})
  if(GEARGRAPH_UNITY)
    set_target_properties(${library} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    set_source_files_properties(${LAYER_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  if(LAYER_QT)
    set_target_properties(${library} PROPERTIES AUTOMOC ON)
    foreach(module IN LISTS LAYER_QT)
      target_link_libraries(${library} PUBLIC Qt6::${module})
    endforeach()
  endif()

  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE ";" "," uses "${LAYER_USES}")
  string(REPLACE ";" "," qt "${LAYER_QT}")
  set_property(GLOBAL APPEND PROPERTY GEARGRAPH_LAYERS "${name}|${folder}|${uses}|${qt}")
endfunction()

# geargraph_test(name LABELS labels... USES layers... SOURCES files... [QT modules...] [PLAIN] [ARGUMENTS args...])
#
# One Qt Test program, registered with ctest as <first label>.<name>. It links exactly the layers it names.
# PLAIN: the program brings its own main() and no Qt, for thread tests under TSan.
function(geargraph_test name)
  cmake_parse_arguments(T "PLAIN" "" "SOURCES;USES;QT;LABELS;ARGUMENTS" ${ARGN})
  if(NOT T_PLAIN AND NOT GEARGRAPH_QT)
    return()
  endif()
  set(program test_${name})
  add_executable(${program} ${T_SOURCES})
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${program} PRIVATE geargraph_warnings)
  foreach(used IN LISTS T_USES)
    target_link_libraries(${program} PRIVATE geargraph_${used})
  endforeach()
  if(NOT T_PLAIN)
    set_target_properties(${program} PROPERTIES AUTOMOC ON)
    target_link_libraries(${program} PRIVATE Qt6::Test)
    foreach(module IN LISTS T_QT)
      target_link_libraries(${program} PRIVATE Qt6::${module})
    endforeach()
  endif()
  list(GET T_LABELS 0 first)
  add_test(NAME ${first}.${name} COMMAND ${program} ${T_ARGUMENTS})
  set_tests_properties(${first}.${name} PROPERTIES LABELS "${T_LABELS}" TIMEOUT 600
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8")
endfunction()

# Writes the list of layers for quality.layering: one line "name|folder|uses|qt" a layer.
function(geargraph_write_layers file)
  get_property(layers GLOBAL PROPERTY GEARGRAPH_LAYERS)
  string(REPLACE ";" "\n" text "${layers}")
  file(WRITE ${file} "${text}\n")
endfunction()
