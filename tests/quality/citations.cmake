cmake_minimum_required(VERSION 3.25)

# Every page that a comment cites is in the repository: written from its root, or from the folder of the file.
# -D SOURCE=checkout

include("${CMAKE_CURRENT_LIST_DIR}/check_lines.cmake")

function(check_line file comment)
  string(REGEX REPLACE "^.*//" "" comment "${comment}")
  string(REGEX MATCHALL "[A-Za-z0-9_./-]+\\.md" pages "${comment}")
  get_filename_component(folder "${file}" DIRECTORY)
  foreach(page IN LISTS pages)
    count_check()
    if(NOT EXISTS "${SOURCE}/${page}" AND NOT EXISTS "${folder}/${page}")
      complain("${file}: cites ${page}, which is not in the repository")
    endif()
  endforeach()
endfunction()

set(files "")
foreach(folder core ui app tests)
  file(GLOB_RECURSE found "${SOURCE}/${folder}/*.h" "${SOURCE}/${folder}/*.cpp")
  list(APPEND files ${found})
endforeach()
check_lines("//.*[A-Za-z_]\\.md" ${files})
report_checks(citation "Comments cite pages that a reader does not have" "lead to a page")
