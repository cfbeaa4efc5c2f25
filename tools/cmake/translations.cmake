# Languages: resources/translations/geargraph_<language>.ts, one catalogue for the words of core and of the window.
#
#   cmake --build build/release --target translations    brings the catalogues up to date with the sources
#
# quality.translations fails on whatever is then left to be translated, and names it.

set(GEARGRAPH_LANGUAGES de tr es)   # beside English, the language of the sources
set(geargraph_catalogues ${GEARGRAPH_LANGUAGES})
list(TRANSFORM geargraph_catalogues REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/resources/translations/geargraph_\\1.ts")
set(geargraph_extract ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D LUPDATE=$<TARGET_FILE:Qt6::lupdate>
  -P ${PROJECT_SOURCE_DIR}/tools/translations/extract.cmake)
add_custom_target(translations
  COMMAND ${geargraph_extract} ${CMAKE_BINARY_DIR}/translations/sources -no-obsolete -ts ${geargraph_catalogues} VERBATIM)

# geargraph_embed_languages(target): the compiled catalogues, and Qt's own for its dialogs, as /translations/*.qm.
function(geargraph_embed_languages target)
  get_target_property(qmake Qt6::qmake IMPORTED_LOCATION)
  execute_process(COMMAND ${qmake} -query QT_INSTALL_TRANSLATIONS OUTPUT_VARIABLE of_qt OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/translations)
  file(MAKE_DIRECTORY ${folder})
  set(compiled "")
  foreach(language catalogue IN ZIP_LISTS GEARGRAPH_LANGUAGES geargraph_catalogues)
    add_custom_command(OUTPUT ${folder}/geargraph_${language}.qm
      COMMAND Qt6::lrelease -silent ${catalogue} -qm ${folder}/geargraph_${language}.qm
      DEPENDS ${catalogue} VERBATIM)
    list(APPEND compiled ${folder}/geargraph_${language}.qm)
    if(NOT EXISTS ${of_qt}/qtbase_${language}.qm)
      message(FATAL_ERROR "${of_qt}/qtbase_${language}.qm was not found; tools/packages.txt names the packages that are needed.")
    endif()
    configure_file(${of_qt}/qtbase_${language}.qm ${folder}/qtbase_${language}.qm COPYONLY)
    list(APPEND compiled ${folder}/qtbase_${language}.qm)
  endforeach()
  qt_add_resources(${target} languages PREFIX /translations BASE ${folder} FILES ${compiled})
endfunction()
