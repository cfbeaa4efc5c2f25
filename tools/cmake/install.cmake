# What `cmake --install build/release --component development` puts into place: the layers of core as static libraries
# (GearGraph::model, GearGraph::analysis, ...), their public headers, and what find_package(GearGraph) reads.

include(CMakePackageConfigHelpers)
set(GEARGRAPH_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/GearGraph)

# The libraries of others that a layer and those below it are linked with.
function(geargraph_externals_of result layer)
  get_property(layers GLOBAL PROPERTY GEARGRAPH_LAYERS)
  set(open ${layer})
  set(seen "")
  set(externals "")
  while(open)
    list(POP_FRONT open next)
    if(next IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${next})
    get_property(own GLOBAL PROPERTY GEARGRAPH_EXTERNALS_OF_${next})
    list(APPEND externals ${own})
    set(line ${layers})
    list(FILTER line INCLUDE REGEX "^${next}[|]")
    string(REGEX REPLACE "^[^|]*[|][^|]*[|]([^|]*)[|].*$" "\\1" uses "${line}")
    string(REPLACE "," ";" uses "${uses}")
    list(APPEND open ${uses})
  endwhile()
  list(REMOVE_DUPLICATES externals)
  set(${result} "${externals}" PARENT_SCOPE)
endfunction()

get_property(GEARGRAPH_COMPONENTS GLOBAL PROPERTY GEARGRAPH_INSTALLED_LAYERS)
set(GEARGRAPH_NEEDS "")
foreach(layer IN LISTS GEARGRAPH_COMPONENTS)
  geargraph_externals_of(externals ${layer})
  string(APPEND GEARGRAPH_NEEDS "set(GearGraph_${layer}_NEEDS \"${externals}\")\n")
endforeach()

set(config ${CMAKE_CURRENT_BINARY_DIR}/GearGraphConfig.cmake)
set(version ${CMAKE_CURRENT_BINARY_DIR}/GearGraphConfigVersion.cmake)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/GearGraphConfig.cmake.in ${config}
  INSTALL_DESTINATION ${GEARGRAPH_PACKAGE_FOLDER})
write_basic_package_version_file(${version} COMPATIBILITY SameMinorVersion)
install(FILES ${config} ${version} ${CMAKE_CURRENT_LIST_DIR}/externals.cmake ${CMAKE_CURRENT_LIST_DIR}/FindFLINT.cmake
  DESTINATION ${GEARGRAPH_PACKAGE_FOLDER} COMPONENT development)
install(EXPORT GearGraphTargets NAMESPACE GearGraph:: DESTINATION ${GEARGRAPH_PACKAGE_FOLDER} COMPONENT development)

# Which headers are public is read from the sources when they are installed.
install(CODE "set(GEARGRAPH_SOURCE \"${PROJECT_SOURCE_DIR}\")
set(GEARGRAPH_HEADERS \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/geargraph\")" COMPONENT development)
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_headers.cmake COMPONENT development)
