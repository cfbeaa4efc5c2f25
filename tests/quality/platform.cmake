cmake_minimum_required(VERSION 3.25)

# Headers of one system, and questions which system it is, are in core/foundations/platform only. Below are the files
# that still have some, and why; a file that needs its line no longer has to leave the list.
# -D SOURCE=checkout [-D EXCEPTIONS=list of files, for the test of this check]

include("${CMAKE_CURRENT_LIST_DIR}/check_lines.cmake")

if(NOT DEFINED EXCEPTIONS)
  set(EXCEPTIONS
    # One file a subject, each behind a header without the system; not yet with a portable variant.
    app/cli/served_command.cpp                     # a process for each request, with a limit of memory
    core/presentation/gl_renderer/egl_host.cpp        # OpenGL without a window: EGL
    ui/recovery/crash_handler.cpp                     # signals and stack traces
    # The sandbox is Linux' own; sandbox_portable.cpp stands in for it.
    core/foundations/sandbox/call_filter.cpp
    core/foundations/sandbox/file_rules.cpp
    core/foundations/sandbox/sandbox.cpp)
endif()

set(headers "(unistd|fcntl|poll|spawn|pthread|dlfcn|sched|semaphore|signal|ucontext|execinfo|termios|grp|pwd|seccomp|elf|link|windows|io|direct|process)[.]h")
set(folders "(sys|linux|asm|netinet|arpa|mach|EGL|X11)/[^>]*")
set(systems "(__linux__|__unix__|__APPLE__|_WIN32)")

function(check_line file line)
  count_check()
  file(RELATIVE_PATH name "${SOURCE}" "${file}")
  set_property(GLOBAL APPEND PROPERTY tied "${name}")
  if(NOT name IN_LIST EXCEPTIONS AND NOT name MATCHES "^core/foundations/platform/")
    complain("${name}: ${line}: what only one system has belongs into core/foundations/platform")
  endif()
endfunction()

file(GLOB_RECURSE files "${SOURCE}/core/*.h" "${SOURCE}/core/*.cpp" "${SOURCE}/app/*.h" "${SOURCE}/app/*.cpp"
  "${SOURCE}/ui/*.h" "${SOURCE}/ui/*.cpp")
check_lines("^[ \t]*#[ \t]*(include[ \t]*<(${headers}|${folders})>|.*${systems})" ${files})

get_property(tied GLOBAL PROPERTY tied)
foreach(name IN LISTS EXCEPTIONS)
  if(NOT name IN_LIST tied)
    complain("${name} is an exception of quality.platform, but needs none")
  endif()
endforeach()
report_checks("line about a system" "The source is tied to one system outside of core/foundations/platform"
  "are where they belong")
