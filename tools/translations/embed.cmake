# cmake -D OUTPUT=file.cpp -P embed.cmake catalogues (.ts)...
#
# Writes catalogues as C++ for programs without Qt (app/cli/catalogues.h): each text that is translated, with its
# translation. Texts with plural forms are those of the window and are left out.
cmake_minimum_required(VERSION 3.25)
set(catalogues "")
set(after FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(after)
    list(APPEND catalogues "${CMAKE_ARGV${i}}")
  elseif("${CMAKE_ARGV${i}}" MATCHES "embed.cmake$")
    set(after TRUE)
  endif()
endforeach()

set(content "// Written by tools/translations/embed.cmake.\n#include \"app/cli/catalogues.h\"\n\n#include <array>\n\n")
string(APPEND content "namespace geargraph::cli {\nnamespace {\n\n")
set(all "")
foreach(catalogue IN LISTS catalogues)
  string(REGEX REPLACE ".*_([a-z]+)[.]ts$" "\\1" language "${catalogue}")
  file(READ "${catalogue}" text)
  # Lists are of no use here: texts have semicolons and brackets.
  string(REGEX MATCHALL "<source>[^<]*</source>[ \n]*<translation>[^<]+</translation>" entries "${text}")
  string(REGEX REPLACE "<source>([^<]*)</source>[ \n]*<translation>([^<]+)</translation>;?"
    "    {R\"ts(\\1)ts\", R\"ts(\\2)ts\"},\n" entries "${entries}")
  foreach(entity "&lt;=<" "&gt;=>" "&quot;=\"" "&apos;='" "&amp;=&")
    string(REGEX REPLACE "=.*" "" from "${entity}")
    string(REGEX REPLACE "^[^=]*=" "" to "${entity}")
    string(REPLACE "${from}" "${to}" entries "${entries}")
  endforeach()
  string(APPEND content "constexpr CompiledText k_${language}[] = {\n${entries}};\n\n")
  string(APPEND all "    {\"${language}\", k_${language}},\n")
endforeach()
string(APPEND content "constexpr CompiledCatalogue kAll[] = {\n${all}};\n\n}  // namespace\n\n")
string(APPEND content "std::span<const CompiledCatalogue> catalogues() {\n  return kAll;\n}\n\n}  // namespace geargraph::cli\n")
file(WRITE "${OUTPUT}" "${content}")
