# cmake -D SOURCE=root -D LUPDATE=program -P extract.cmake folder [options of lupdate] -ts catalogues...
#
# Brings the catalogues (.ts) up to date with the sources. Core has no tr(): so lupdate reads copies in `folder`, in which
# every marked text is of one context.
set(arguments "")
set(after FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(after)
    list(APPEND arguments "${CMAKE_ARGV${i}}")
  elseif(CMAKE_ARGV${i} MATCHES "extract.cmake$")
    set(after TRUE)
  endif()
endforeach()
list(POP_FRONT arguments folder)

set(literal "[ \n]*\"([^\"\\\\]|\\\\.)*\"")
file(REMOVE_RECURSE ${folder})
file(GLOB_RECURSE sources RELATIVE ${SOURCE} ${SOURCE}/core/*.cpp ${SOURCE}/core/*.h ${SOURCE}/ui/*.cpp ${SOURCE}/ui/*.h
  ${SOURCE}/app/*.cpp ${SOURCE}/app/*.h)
foreach(source IN LISTS sources)
  file(READ ${SOURCE}/${source} text)
  # The functions that mark texts: tr("..."), Class::tr("..."), translate("Context", "..."), words("..."), translated("..."), toTranslate("...")
  # What core's have behind their text is none of lupdate's matters, but that a number asks for plural forms.
  string(REGEX REPLACE "translated\\(((${literal})+),[ \n]*{" "translated(\\1); ({" marked "${text}")
  string(REGEX REPLACE "translated\\(((${literal})+),[ \n]*([^{ \n])" "translate(\"GearGraph\", \\1, nullptr, \\4" marked "${marked}")
  string(REGEX REPLACE "([^A-Za-z0-9_:])(([A-Za-z0-9_]+::)*)(tr|words|translated|toTranslate)\\(" "\\1translate(\"GearGraph\", " marked "${marked}")
  string(REGEX REPLACE "([^A-Za-z0-9_])translate\\([ \n]*\"[A-Za-z0-9_:]*\"" "\\1translate(\"GearGraph\"" marked "${marked}")
  if(NOT marked STREQUAL text)
    file(WRITE ${folder}/${source} "${marked}")
  endif()
endforeach()
execute_process(COMMAND ${LUPDATE} -silent ${folder} -extensions cpp,h -locations none -no-ui-lines -source-language en
  ${arguments} RESULT_VARIABLE failed ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "${said}")
endif()
