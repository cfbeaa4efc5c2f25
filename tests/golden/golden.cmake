cmake_minimum_required(VERSION 3.25)

# Runs geargraph-cli from the top of the checkout and compares all that it says with a stored text.
# -D PROGRAM=… -D SOURCE=checkout -D EXPECTED=file -D WORDS=the|words|behind|it [-D INPUT=file for standard input]
# With GEARGRAPH_UPDATE_GOLDEN=1 in the environment the stored text is written instead: look at its diff.

string(REPLACE "|" ";" words "${WORDS}")
set(input "")
if(INPUT)
  set(input INPUT_FILE "${SOURCE}/${INPUT}")
endif()
execute_process(COMMAND "${PROGRAM}" ${words} ${input} WORKING_DIRECTORY "${SOURCE}"
  OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE status)

string(REPLACE ";" " " line "${words}")
set(found "$ geargraph-cli ${line}\n${output}")
if(NOT errors STREQUAL "")
  string(APPEND found "[standard error]\n${errors}")
endif()
string(APPEND found "[exit status ${status}]\n")

if("$ENV{GEARGRAPH_UPDATE_GOLDEN}")
  file(WRITE "${EXPECTED}" "${found}")
  message(STATUS "Written: ${EXPECTED}")
  return()
endif()
if(EXISTS "${EXPECTED}")
  file(READ "${EXPECTED}" wanted)
else()
  set(wanted "")
endif()
if(NOT found STREQUAL wanted)
  get_filename_component(name "${EXPECTED}" NAME)
  set(actual "${CMAKE_CURRENT_BINARY_DIR}/${name}.actual")
  file(WRITE "${actual}" "${found}")
  execute_process(COMMAND diff -u "${EXPECTED}" "${actual}")
  message(FATAL_ERROR "Not what ${EXPECTED} says. If it is better, run again with GEARGRAPH_UPDATE_GOLDEN=1.")
endif()
