# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Run at build time: makes FOLDER/mathjax.js out of SOURCES with NPM, or copies READY_MADE, and
# writes the FOLDER/mathjax.qrc that names it. Never fails: without a script the list leaves it out.

file(MAKE_DIRECTORY "${FOLDER}")
file(REMOVE "${FOLDER}/mathjax.js")

if(READY_MADE)
    configure_file("${READY_MADE}" "${FOLDER}/mathjax.js" COPYONLY)
elseif(NPM)
    file(COPY ${SOURCES} DESTINATION "${FOLDER}")
    execute_process(
        COMMAND "${NPM}" ci --no-audit --no-fund --prefer-offline --ignore-scripts
        WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE failure
        OUTPUT_VARIABLE log ERROR_VARIABLE log)
    if(NOT failure)
        execute_process(
            COMMAND "${NPM}" run build
            WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE failure
            OUTPUT_VARIABLE log ERROR_VARIABLE log)
    endif()
    if(failure)
        file(REMOVE "${FOLDER}/mathjax.js")
        file(WRITE "${FOLDER}/npm.log" "${log}")
        message("npm could not install MathJax (see ${FOLDER}/npm.log): "
                "formulas will show as text. To try again, remove ${FOLDER}/../qrc_mathjax.cpp.")
    endif()
endif()

# The application keeps formulas it has drawn; this number tells it that they are out of date.
set(version "none")
set(script "")
if(EXISTS "${FOLDER}/mathjax.js")
    file(SHA256 "${FOLDER}/mathjax.js" version)
    set(script "<file>mathjax.js</file>")
endif()
file(WRITE "${FOLDER}/version" "${version}\n")
file(WRITE "${FOLDER}/mathjax.qrc"
    "<RCC><qresource prefix=\"/mathjax\">${script}<file>version</file></qresource></RCC>\n")
