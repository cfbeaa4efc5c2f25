cmake_minimum_required(VERSION 3.25)

# Builds small trees with and without a cycle and demands that cycles.cmake tells them apart.

file(REMOVE_RECURSE "${WORK}")
file(WRITE "${WORK}/ui/shop/main_window.h" "#include \"ui/shop/panel.h\"\nclass MainWindow;\n")
file(WRITE "${WORK}/ui/shop/window_bars.cpp"
  "#include \"ui/shop/main_window.h\"\n#include \"ui/shop/files.h\"\nvoid MainWindow::makeBars() {}\n")
file(WRITE "${WORK}/ui/shop/panel.h" "class Panel;\n")
file(WRITE "${WORK}/ui/shop/files.h" "class Files;\n")
file(WRITE "${WORK}/ui/shop/files.cpp" "#include \"ui/shop/files.h\"\n#include \"ui/shop/panel.h\"\n")
function(check status errors)
  execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE=${WORK} -P "${CHECK}"
    RESULT_VARIABLE result ERROR_VARIABLE text OUTPUT_QUIET)
  set(${status} ${result} PARENT_SCOPE)
  set(${errors} "${text}" PARENT_SCOPE)
endfunction()

check(status errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "The check rejected a tree without a cycle\n${errors}")
endif()

# Only a source of the window that has another name needs the files.
file(WRITE "${WORK}/ui/shop/files.cpp" "#include \"ui/shop/files.h\"\n#include \"ui/shop/main_window.h\"\n")
check(status errors)
if(status EQUAL 0)
  message(FATAL_ERROR "The check passed a tree with a cycle")
endif()
foreach(expected "ui/shop/main_window needs ui/shop/files" "ui/shop/files needs ui/shop/main_window")
  string(FIND "${errors}" "${expected}" at)
  if(at EQUAL -1)
    message(SEND_ERROR "Not found: ${expected}\n${errors}")
  endif()
endforeach()
if(errors MATCHES "panel needs")
  message(FATAL_ERROR "The check named a unit that is on no cycle")
endif()
