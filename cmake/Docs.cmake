# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The target docs: docs/api in the build folder, by Doxygen; a warning fails it.
find_program(CRADLE_DOXYGEN doxygen)
configure_file("${CMAKE_SOURCE_DIR}/docs/Doxyfile.in" "${CMAKE_BINARY_DIR}/docs/Doxyfile" @ONLY)
if(CRADLE_DOXYGEN)
    add_custom_target(docs COMMAND "${CRADLE_DOXYGEN}" "${CMAKE_BINARY_DIR}/docs/Doxyfile"
                      COMMENT "Writing docs/api" VERBATIM)
else()
    add_custom_target(docs COMMAND "${CMAKE_COMMAND}" -E echo
                      "Doxygen is missing: apt-get install doxygen, and configure again"
                      COMMAND "${CMAKE_COMMAND}" -E false VERBATIM)
endif()
