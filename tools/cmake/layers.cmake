# Layers: one folder below core/ or ui/ = one static library = one layer.

include(GNUInstallDirs)
set_property(GLOBAL PROPERTY GEARGRAPH_LAYERS "")

# geargraph_quick_build(target headers [LIGHT]): how unity builds (GEARGRAPH_UNITY) save time with a target. Its sources are compiled
# a dozen together, with headers of others that were compiled once for all: those of the library (standard), also of Eigen
# (geometry), also of Qt (widgets). LIGHT: with -O1, a third quicker, where time is not spent in loops of the target's own
# (measured by tools/bench).
function(geargraph_quick_build target headers)
  if(NOT GEARGRAPH_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  if("LIGHT" IN_LIST ARGN)
    geargraph_light(${target})
  endif()
  geargraph_shared_headers(${headers})
  target_compile_options(${target} PRIVATE ${GEARGRAPH_SHARED_HEADER_OPTIONS})
  target_precompile_headers(${target} REUSE_FROM geargraph_${headers}_headers)
endfunction()

# geargraph_light(target): -O1 in optimised builds.
function(geargraph_light target)
  if(NOT MSVC)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# What has to be said to GCC where std::string comes compiled: its bug 105651 again.
set(GEARGRAPH_SHARED_HEADER_OPTIONS
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread> $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)

# geargraph_shared_headers(standard | geometry | widgets): the target geargraph_<name>_headers, made when first asked for.
function(geargraph_shared_headers name)
  set(target geargraph_${name}_headers)
  if(TARGET ${target})
    return()
  endif()
  set(headers <algorithm> <array> <charconv> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <mutex> <numbers> <numeric>
    <optional> <set> <span> <stop_token> <string> <string_view> <unordered_map> <unordered_set> <utility> <variant> <vector>)
  set(source ${CMAKE_BINARY_DIR}/shared_headers.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "namespace geargraph {}\n" @ONLY)
  add_library(${target} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(${target} PRIVATE geargraph_warnings)
  target_compile_options(${target} PRIVATE ${GEARGRAPH_SHARED_HEADER_OPTIONS})
  if(name STREQUAL geometry)
    target_link_libraries(${target} PRIVATE Eigen3::Eigen)
    list(APPEND headers <Eigen/Geometry>)
  elseif(name STREQUAL widgets)
    target_link_libraries(${target} PRIVATE Qt6::Widgets)
    list(APPEND headers <QAction> <QApplication> <QBoxLayout> <QComboBox> <QDialog> <QDockWidget> <QFileInfo> <QHeaderView> <QKeyEvent>
      <QLabel> <QLineEdit> <QMainWindow> <QMenu> <QMouseEvent> <QPainter> <QPainterPath> <QPushButton> <QScrollArea> <QStackedWidget>
      <QStyledItemDelegate> <QTableView> <QTimer> <QToolButton>)
  endif()
  target_precompile_headers(${target} PRIVATE ${headers})
endfunction()

# geargraph_layer(name SOURCES files... [NO_UNITY files...] [USES layers...] [QT modules...] [EXTERNAL targets...] [LIGHT])
#
# Makes the static library geargraph_<name> from the files of this folder. USES names the layers it may include
# from and is linked publicly; it is the only place a dependency between layers is written. The test
# quality.layering reads the same list. QT turns on moc and Qt's include paths; a layer without QT cannot
# include a Qt header, because no such path reaches its compiler. NO_UNITY: sources whose local names others of the layer
# have, too; unity builds (GEARGRAPH_UNITY) compile them by themselves. LIGHT: see geargraph_quick_build(); a layer with QT is.
function(geargraph_layer name)
  cmake_parse_arguments(LAYER "LIGHT" "" "SOURCES;NO_UNITY;USES;QT;EXTERNAL" ${ARGN})
  if(LAYER_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "geargraph_layer(${name}): unknown arguments ${LAYER_UNPARSED_ARGUMENTS}")
  endif()
  set(library geargraph_${name})
  add_library(${library} STATIC ${LAYER_SOURCES})
  target_include_directories(${library} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_link_libraries(${library} PRIVATE $<BUILD_INTERFACE:geargraph_warnings>)
  foreach(used IN LISTS LAYER_USES)
    target_link_libraries(${library} PUBLIC geargraph_${used})
  endforeach()
  target_link_libraries(${library} PUBLIC ${LAYER_EXTERNAL})
  set(headers standard)
  if("Widgets" IN_LIST LAYER_QT)
    set(headers widgets)
  elseif(NOT CMAKE_CURRENT_SOURCE_DIR MATCHES "/core/(foundations|mechanism)/" AND NOT LAYER_QT)
    set(headers geometry)
  endif()
  if(LAYER_QT OR LAYER_LIGHT)
    geargraph_quick_build(${library} ${headers} LIGHT)
  else()
    geargraph_quick_build(${library} ${headers})
  endif()
  if(GEARGRAPH_UNITY)
    set_source_files_properties(${LAYER_NO_UNITY} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  if(LAYER_QT)
    set_target_properties(${library} PROPERTIES AUTOMOC ON)
    # Sources include what moc makes of their headers, so that next to nothing is left here.
    set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${library}_autogen/mocs_compilation.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    foreach(module IN LISTS LAYER_QT)
      target_link_libraries(${library} PUBLIC Qt6::${module})
    endforeach()
  endif()

  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE ";" "," uses "${LAYER_USES}")
  string(REPLACE ";" "," qt "${LAYER_QT}")
  set_property(GLOBAL APPEND PROPERTY GEARGRAPH_LAYERS "${name}|${folder}|${uses}|${qt}")
  set_property(GLOBAL PROPERTY GEARGRAPH_EXTERNALS_OF_${name} "${LAYER_EXTERNAL}")
  if(folder MATCHES "^core/")
    geargraph_install_layer(${name})
  endif()
endfunction()

# geargraph_install_layer(name): a layer of core is the target GearGraph::<name> of find_package(GearGraph), see install.cmake.
function(geargraph_install_layer name)
  set(library geargraph_${name})
  add_library(GearGraph::${name} ALIAS ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${library} INTERFACE cxx_std_20)
  install(TARGETS ${library} EXPORT GearGraphTargets ARCHIVE COMPONENT development
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/geargraph)
  set_property(GLOBAL APPEND PROPERTY GEARGRAPH_INSTALLED_LAYERS ${name})
endfunction()

# geargraph_test(name LABELS labels... USES layers... SOURCES files... [QT modules...] [LINKS targets...] [DEFINES macros...]
#   [NEEDS programs...] [NO_UNITY] [PLAIN] [ARGUMENTS args...])
#
# One class of Qt Test, registered with ctest as <first label>.<name>. It has a program of its own, test_<name>, which links
# exactly the layers it names. In unity builds (GEARGRAPH_UNITY) all classes of a group share a program, tests_<group>, and are
# compiled together (tests/support/test_class.h). LINKS: libraries that are no layers. DEFINES: the same in all tests of a
# group. NEEDS: programs that it starts. NO_UNITY: its own program always, because it has its own main() or macros, or is linked
# in its own way. PLAIN: the program brings its own main() and no Qt, for thread tests under TSan.
function(geargraph_test name)
  cmake_parse_arguments(T "PLAIN;NO_UNITY" "" "SOURCES;USES;QT;LINKS;DEFINES;NEEDS;LABELS;ARGUMENTS" ${ARGN})
  if(T_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "geargraph_test(${name}): unknown arguments ${T_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT T_PLAIN AND NOT GEARGRAPH_QT)
    return()
  endif()
  list(TRANSFORM T_SOURCES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/$]")
  if(GEARGRAPH_UNITY AND NOT T_PLAIN AND NOT T_NO_UNITY)
    geargraph_group_of_tests(group)
    set(program tests_${group})
    set_property(GLOBAL APPEND PROPERTY GEARGRAPH_TEST_PROGRAMS ${program})
    foreach(part SOURCES USES QT LINKS DEFINES NEEDS)
      set_property(GLOBAL APPEND PROPERTY GEARGRAPH_${part}_OF_${program} ${T_${part}})
    endforeach()
    list(GET T_SOURCES 0 source)
    cmake_path(GET source STEM class)
    list(PREPEND T_ARGUMENTS ${class})
  else()
    set(program test_${name})
    geargraph_test_program(${program} "${T_SOURCES}" "${T_USES}" "${T_QT}" "${T_LINKS}" "${T_DEFINES}" "${T_NEEDS}" ${T_PLAIN})
  endif()
  list(GET T_LABELS 0 first)
  add_test(NAME ${first}.${name} COMMAND ${program} ${T_ARGUMENTS})
  set_tests_properties(${first}.${name} PROPERTIES LABELS "${T_LABELS}" TIMEOUT 600
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8")
endfunction()

# The group that the tests of this folder belong to: core_theory for core/theory/statics, mainwindow apart from the rest of ui.
function(geargraph_group_of_tests result)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/tests ${CMAKE_CURRENT_SOURCE_DIR})
  string(REGEX MATCH "^(core/[^/]+|ui/mainwindow|[^/]+)" group ${folder})
  string(REPLACE "/" "_" group ${group})
  set(${result} ${group} PARENT_SCOPE)
endfunction()

# geargraph_test_program(program sources layers qt links defines needs plain): the target, lists given as one argument each.
function(geargraph_test_program program sources layers qt links defines needs plain)
  add_executable(${program} ${sources})
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${program} PRIVATE ${defines})
  target_link_libraries(${program} PRIVATE geargraph_warnings ${links})
  foreach(layer IN LISTS layers)
    target_link_libraries(${program} PRIVATE geargraph_${layer})
  endforeach()
  if(needs)
    add_dependencies(${program} ${needs})
  endif()
  if(plain)
    return()
  endif()
  set_target_properties(${program} PROPERTIES AUTOMOC ON)
  geargraph_light(${program})
  target_link_libraries(${program} PRIVATE Qt6::Test)
  if(GEARGRAPH_LIBCXX)
    target_sources(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/libcxx_byte_array.cpp)
  endif()
  foreach(module IN LISTS qt)
    target_link_libraries(${program} PRIVATE Qt6::${module})
  endforeach()
  if(GEARGRAPH_UNITY)
    geargraph_reuse_test_headers(${program} ${layers} ${qt})
  endif()
endfunction()

# The programs of whole groups, once all their tests are known (GEARGRAPH_UNITY).
function(geargraph_finish_test_programs)
  get_property(programs GLOBAL PROPERTY GEARGRAPH_TEST_PROGRAMS)
  list(REMOVE_DUPLICATES programs)
  foreach(program IN LISTS programs)
    foreach(part SOURCES USES QT LINKS DEFINES NEEDS)
      get_property(${part} GLOBAL PROPERTY GEARGRAPH_${part}_OF_${program})
      list(REMOVE_DUPLICATES ${part})
    endforeach()
    set(main ${PROJECT_SOURCE_DIR}/tests/support/test_classes.cpp)
    geargraph_test_program(${program} "${SOURCES};${main}" "${USES}" "${QT}" "${LINKS}" "${DEFINES}" "${NEEDS}" FALSE)
    set_source_files_properties(${main} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8
      UNITY_BUILD_CODE_BEFORE_INCLUDE "#include \"tests/support/test_class.h\"")
  endforeach()
endfunction()

# The modules among Gui, Widgets and Network that the layers bring, with those that they use: QtTest has more for each.
function(geargraph_qt_of result)
  get_property(layers GLOBAL PROPERTY GEARGRAPH_LAYERS)
  foreach(line IN LISTS layers)
    string(REGEX MATCH "^([^|]*)[|][^|]*[|]([^|]*)[|]([^|]*)$" matched "${line}")
    string(REPLACE "," ";" uses_of_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
    set(qt_of_${CMAKE_MATCH_1} "${CMAKE_MATCH_3}")
  endforeach()
  set(open ${ARGN})
  set(modules "")
  while(open)
    list(POP_FRONT open name)
    if(NOT DEFINED seen_${name})
      set(seen_${name} TRUE)
      list(APPEND open ${uses_of_${name}})
      string(APPEND modules " ${name} ${qt_of_${name}}")
    endif()
  endwhile()
  set(found "")
  if(modules MATCHES "Widgets|PrintSupport")
    list(APPEND found Gui Widgets)
  elseif(modules MATCHES "Gui|Svg|OpenGL")
    list(APPEND found Gui)
  endif()
  if(modules MATCHES "Network")
    list(APPEND found Network)
  endif()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# geargraph_reuse_test_headers(program names...): the headers that every Qt Test program reads, compiled once for all
# programs of the same modules (names: layers and modules of the program). Qt defines each program's own folders as
# macros, which compiled headers must not know.
function(geargraph_reuse_test_headers program)
  geargraph_qt_of(modules ${ARGN})
  string(REPLACE ";" "" kind "geargraph_test_headers${modules}")
  set(options -UQT_TESTCASE_BUILDDIR -UQT_TESTCASE_SOURCEDIR ${GEARGRAPH_SHARED_HEADER_OPTIONS})
  if(NOT TARGET ${kind})
    set(source ${CMAKE_BINARY_DIR}/test_headers.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "int main() {}\n" @ONLY)
    add_executable(${kind} EXCLUDE_FROM_ALL ${source})
    target_link_libraries(${kind} PRIVATE geargraph_warnings Qt6::Test)
    foreach(module IN LISTS modules)
      target_link_libraries(${kind} PRIVATE Qt6::${module})
    endforeach()
    target_compile_options(${kind} PRIVATE ${options})
    target_precompile_headers(${kind} PRIVATE <QtTest> <algorithm> <cmath> <functional> <map> <memory> <numbers>
      <optional> <set> <span> <string> <unordered_map> <vector>)
  endif()
  target_compile_options(${program} PRIVATE ${options})
  target_precompile_headers(${program} REUSE_FROM ${kind})
endfunction()

# Writes the list of layers for quality.layering: one line "name|folder|uses|qt" a layer.
function(geargraph_write_layers file)
  get_property(layers GLOBAL PROPERTY GEARGRAPH_LAYERS)
  string(REPLACE ";" "\n" text "${layers}")
  file(WRITE ${file} "${text}\n")
endfunction()
