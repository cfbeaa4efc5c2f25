cmake_minimum_required(VERSION 3.25)

# Builds a small tree with a source that includes something before its own header and demands that headers.cmake
# names it.

file(REMOVE_RECURSE "${WORK}")
file(WRITE "${WORK}/core/good.h" "")
file(WRITE "${WORK}/core/good.cpp" "#include \"core/good.h\"\n\n#include <vector>\n")
file(WRITE "${WORK}/core/late.h" "")
file(WRITE "${WORK}/core/late.cpp" "#include <vector>\n#include \"core/late.h\"\n")
execute_process(
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${WORK} -P "${CHECK}"
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(status EQUAL 0 OR NOT errors MATCHES "late.cpp: the first include has to be core/late.h")
  message(FATAL_ERROR "The check passed a header that does not stand alone\n${errors}")
endif()
if(errors MATCHES "good.cpp")
  message(FATAL_ERROR "The check refused a header that stands alone")
endif()
