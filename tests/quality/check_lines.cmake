# What the checks of this folder share that look at lines of source files. A check includes this file, defines
# check_line(file line), which calls count_check() for each thing that it looks at and complain(text) for what is
# wrong, calls check_lines() and ends with report_checks().

# Calls check_line(file line) for each line of the files (absolute paths) that matches the pattern. check_line sees
# the caller's variables.
function(check_lines pattern)
  foreach(file IN LISTS ARGN)
    file(STRINGS "${file}" lines REGEX "${pattern}")
    foreach(line IN LISTS lines)
      check_line("${file}" "${line}")
    endforeach()
  endforeach()
endfunction()

function(count_check)
  get_property(checked GLOBAL PROPERTY checked)
  math(EXPR checked "0${checked} + 1")
  set_property(GLOBAL PROPERTY checked ${checked})
endfunction()

function(complain text)
  message(NOTICE "${text}")
  set_property(GLOBAL PROPERTY broken 1)
endfunction()

# Ends the check: with an error where nothing was checked (`things`: what), or something is wrong.
function(report_checks things wrong right)
  get_property(checked GLOBAL PROPERTY checked)
  get_property(broken GLOBAL PROPERTY broken)
  if(NOT checked)
    message(FATAL_ERROR "No ${things} was checked: is ${SOURCE} the checkout?")
  elseif(broken)
    message(FATAL_ERROR "${wrong}")
  endif()
  message(STATUS "${checked} ${things}s ${right}")
endfunction()
