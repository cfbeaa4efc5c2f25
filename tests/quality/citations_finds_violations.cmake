cmake_minimum_required(VERSION 3.25)

# Builds a small tree with a comment that cites a page that is not there and demands that citations.cmake names it.

file(REMOVE_RECURSE "${WORK}")
file(WRITE "${WORK}/core/README.md" "")
file(WRITE "${WORK}/core/machine/teeth/README.md" "")
file(WRITE "${WORK}/core/machine/teeth/good.h" "/// Symbols as in README.md, section 1.\nint a;  // core/README.md\n")
file(WRITE "${WORK}/core/machine/teeth/bad.cpp" "auto page = \"a.md\";\n/// As in theory.md, section b.\n")
execute_process(
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${WORK} -P "${CHECK}"
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(status EQUAL 0 OR NOT errors MATCHES "bad.cpp: cites theory.md")
  message(FATAL_ERROR "The check passed a comment that cites a page that is not there\n${errors}")
endif()
if(errors MATCHES "good.h" OR errors MATCHES "a.md,")
  message(FATAL_ERROR "The check rejected a page that is there\n${errors}")
endif()
