cmake_minimum_required(VERSION 3.25)

# Builds a small tree with former wordings and demands that wordings.cmake names each.

file(REMOVE_RECURSE "${WORK}")
file(WRITE "${WORK}/ui/a.cpp" "button->setText(tr(\"Read the motors\"));\nmenu.addAction(tr(\"Delete\"));\n")
file(WRITE "${WORK}/core/b.cpp" "paragraph(\"12 compared, none differs\");\n")
file(WRITE "${WORK}/resources/help/c.md" "* *Pulled apart* moves the bodies.\n")
file(WRITE "${WORK}/ui/right.cpp" "setText(tr(\"Dim\"));  // a veil over the rest\n")
execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE=${WORK} -P "${CHECK}" RESULT_VARIABLE status ERROR_VARIABLE errors)
foreach(expected "ui/a.cpp: \"Read the motors\" is now" "core/b.cpp: \"none differs\" is now"
    "resources/help/c.md: \"Pulled apart\" is now \"Exploded view\"")
  string(FIND "${errors}" "${expected}" at)
  if(at EQUAL -1)
    message(SEND_ERROR "Not found: ${expected}\n${errors}")
  endif()
endforeach()
if(status EQUAL 0)
  message(FATAL_ERROR "The check passed a tree with former wordings")
endif()
if(errors MATCHES "right.cpp")
  message(FATAL_ERROR "The check refused what is allowed")
endif()
