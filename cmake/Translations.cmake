# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# translations/*.ts become the resource :/translations/*.qm of both programs.
# `cmake --build --preset release --target update_translations` brings new strings into the .ts.
file(GLOB_RECURSE translated CONFIGURE_DEPENDS
     "${CMAKE_SOURCE_DIR}/model/*.cpp" "${CMAKE_SOURCE_DIR}/model/*.h"
     "${CMAKE_SOURCE_DIR}/tasks/*.cpp" "${CMAKE_SOURCE_DIR}/tasks/*.h"
     "${CMAKE_SOURCE_DIR}/views/*.cpp" "${CMAKE_SOURCE_DIR}/views/*.h"
     "${CMAKE_SOURCE_DIR}/app/*.cpp" "${CMAKE_SOURCE_DIR}/app/*.h")
file(GLOB ts_files CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/translations/*.ts")

qt_add_lrelease(cradle_language TS_FILES ${ts_files} QM_FILES_OUTPUT_VARIABLE qm_files)
qt_add_resources(cradle_language translations PREFIX "/translations"
                 BASE "${CMAKE_BINARY_DIR}" OPTIONS ${cradle_rcc_options} FILES ${qm_files})
set(whole_ts_files ${ts_files})
list(REMOVE_ITEM whole_ts_files "${CMAKE_SOURCE_DIR}/translations/cradle_en.ts")
add_custom_target(update_translations
    COMMAND Qt6::lupdate -silent -no-obsolete -locations none -I "${CMAKE_SOURCE_DIR}" ${translated}
            -ts ${whole_ts_files}
    # English needs its plurals only.
    COMMAND Qt6::lupdate -silent -no-obsolete -locations none -pluralonly -I "${CMAKE_SOURCE_DIR}"
            ${translated} -ts "${CMAKE_SOURCE_DIR}/translations/cradle_en.ts"
    VERBATIM)
