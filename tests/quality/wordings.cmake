cmake_minimum_required(VERSION 3.25)

# Wordings that users did not understand, each with the one that took its place, stay gone: from texts and comments
# of the programs, from the manual, the lessons and the handout.
# -D SOURCE=checkout

include("${CMAKE_CURRENT_LIST_DIR}/check_lines.cmake")

set(wordings
  "Drop link=Delete"
  "Let the program choose=Choose inputs for me"
  "Read the motors=Drive by a link's joints, relative to"
  "What to mind=Warnings"
  "\"&?Veil=Dim"
  "Pulled apart=Exploded view"
  "Transparent ground=Transparent background"
  "empty ground=empty area"
  "Ride along=Follow"
  "Call mesh=Make mesh"
  "Nothing is called=No command or term matches"
  "Mechanism without a name=Untitled mechanism"
  "none differs=All entries agree"
  "Found no way for=Links overlap in 3D"
  "its path reads=its path changes axis")
set(former "")
foreach(wording IN LISTS wordings)
  string(REGEX REPLACE "=.*" "" old "${wording}")
  list(APPEND former "${old}")
endforeach()
list(JOIN former "|" pattern)

function(check_line file line)
  file(RELATIVE_PATH name "${SOURCE}" "${file}")
  foreach(wording IN LISTS wordings)
    string(REGEX MATCH "^[^=]*" old "${wording}")
    string(REGEX REPLACE "^[^=]*=" "" new "${wording}")
    if(line MATCHES "${old}")
      complain("${name}: \"${old}\" is now \"${new}\"")
    endif()
  endforeach()
endfunction()

file(GLOB_RECURSE files "${SOURCE}/core/*.h" "${SOURCE}/core/*.cpp" "${SOURCE}/app/*.h" "${SOURCE}/app/*.cpp"
  "${SOURCE}/ui/*.h" "${SOURCE}/ui/*.cpp" "${SOURCE}/resources/help/*.md" "${SOURCE}/resources/lessons/*.json"
  "${SOURCE}/resources/handout/*.js" "${SOURCE}/resources/handout/*.mjs" "${SOURCE}/resources/handout/*.html")
foreach(file IN LISTS files)
  count_check()
endforeach()
check_lines("(${pattern})" ${files})
report_checks("file" "A former wording is back" "keep to the wordings in use")
