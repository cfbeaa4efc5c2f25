cmake_minimum_required(VERSION 3.25)

# Builds a small tree with forbidden includes and demands that layering.cmake names each.

file(REMOVE_RECURSE "${WORK}")
file(WRITE "${WORK}/core/lower/low/low.h" "#include <QString>\n#include \"core/upper/high/high.h\"\n#include \"near.h\"\n")
file(WRITE "${WORK}/core/upper/high/high.h" "#include \"core/lower/low/low.h\"\n#include \"ui/view/view.h\"\n")
file(WRITE "${WORK}/ui/view/view.h" "#include <QString>\n#include \"core/upper/high/high.h\"\n")
file(WRITE "${WORK}/core/lower/deep/deep.h" "")
file(WRITE "${WORK}/core/CMakeLists.txt" "# Groups\nadd_subdirectory(lower)\nadd_subdirectory(upper)\n")
file(WRITE "${WORK}/layers.txt" "deep|core/lower/deep|high|\nlow|core/lower/low||\nhigh|core/upper/high|low|\nview|ui/view|high|Widgets\n")
execute_process(
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${WORK} -D LAYERS=${WORK}/layers.txt -P "${CHECK}"
  RESULT_VARIABLE status ERROR_VARIABLE errors)
foreach(expected "deep may not use high, which is in a group above it" "low has no Qt" "low may not use high" "high may not use view" "near.h\": write includes")
  string(FIND "${errors}" "${expected}" at)
  if(at EQUAL -1)
    message(SEND_ERROR "Not found: ${expected}\n${errors}")
  endif()
endforeach()
if(status EQUAL 0)
  message(FATAL_ERROR "The check passed a tree that breaks the layers")
endif()
if(errors MATCHES "view may not")
  message(FATAL_ERROR "The check refused an allowed include")
endif()
