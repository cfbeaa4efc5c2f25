cmake_minimum_required(VERSION 3.25)

# A kind of gear pair or wheel is asked, not compared: no source names one but those that define the kinds, and those
# that draw certain pairs, which compare none. Every table of facets is one of those that core.kinds lists kinds against.
# -D SOURCE=checkout

include("${CMAKE_CURRENT_LIST_DIR}/check_lines.cmake")

set(definitions core/mechanism/kinds/pair_kind.h core/mechanism/kinds/pair_kind.cpp core/machine/teeth/gear_spec.h
  core/machine/train/pair_wheels.cpp)
# Gears, sets of gears and trains that are made of certain kinds, and the counts that lessons ask for by name.
set(makers core/design/atlas/chain_document.cpp core/design/gearboxes/gearbox_document.cpp core/design/gearboxes/hub_document.cpp core/design/synthesis/bevel_sets.cpp core/design/synthesis/drive_sets.cpp core/design/synthesis/planetary_set.cpp
  core/design/synthesis/reverted_train.cpp core/design/synthesis/shifting_sets.cpp core/machine/teeth/face_gear.cpp core/machine/teeth/worm.cpp core/teaching/derivation/comparison_families.cpp core/teaching/lessons/quantities.cpp)
set(listed "${SOURCE}/tests/core/examples/test_kinds.cpp")
set(tested "")
if(EXISTS "${listed}")
  file(READ "${listed}" tested)
endif()

function(check_line file line)
  file(RELATIVE_PATH name "${SOURCE}" "${file}")
  if(line MATCHES "(MeshKind|GearKind)::" AND NOT name IN_LIST definitions)
    if(NOT name IN_LIST makers)
      complain("${name}: names a kind: ask the kind (core/README.md, Kinds)")
    elseif(line MATCHES "([=!]=|case) *(MeshKind|GearKind)::")
      complain("${name}: compares kinds")
    endif()
  endif()
  if(line MATCHES "KindTable<[A-Za-z]+, [A-Za-z]+>& ([a-zA-Z]+)\\(\\);")
    count_check()
    string(FIND "${tested}" "${CMAKE_MATCH_1}()" at)
    if(at EQUAL -1)
      complain("${name}: core.kinds does not list kinds against ${CMAKE_MATCH_1}()")
    endif()
  endif()
endfunction()

file(GLOB_RECURSE files "${SOURCE}/core/*.h" "${SOURCE}/core/*.cpp" "${SOURCE}/app/*.h" "${SOURCE}/app/*.cpp" "${SOURCE}/ui/*.h"
  "${SOURCE}/ui/*.cpp")
check_lines("(MeshKind|GearKind)::|KindTable<" ${files})
report_checks("table" "Kinds are compared, or a table is not tested" "are listed, and no kind is compared")
