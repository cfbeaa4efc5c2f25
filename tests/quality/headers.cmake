cmake_minimum_required(VERSION 3.25)

# Every header compiles alone. One that has a source of its own name proves it there, by being what that source
# includes first; the others are compiled by the target geargraph_headers_alone.
# -D SOURCE=checkout

set(broken 0)
set(checked 0)
file(GLOB_RECURSE headers RELATIVE "${SOURCE}" "${SOURCE}/core/*.h" "${SOURCE}/ui/*.h" "${SOURCE}/app/*.h")
foreach(header IN LISTS headers)
  string(REGEX REPLACE "\\.h$" ".cpp" source "${SOURCE}/${header}")
  if(EXISTS "${source}")
    math(EXPR checked "${checked} + 1")
    file(STRINGS "${source}" first REGEX "^#include " LIMIT_COUNT 1)
    if(NOT first STREQUAL "#include \"${header}\"")
      message(NOTICE "${source}: the first include has to be ${header}, not ${first}")
      set(broken 1)
    endif()
  endif()
endforeach()
if(checked EQUAL 0)
  message(FATAL_ERROR "No header was checked: is ${SOURCE} the checkout?")
endif()
if(broken)
  message(FATAL_ERROR "Headers may lean on what is included before them")
else()
  message(STATUS "${checked} headers stand alone in their sources")
endif()
