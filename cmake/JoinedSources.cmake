# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Sources of one room are compiled a few at a time: most of a compiler's work is to read what they
# include. So what the unnamed namespaces of a room hold has different names in different files.
# -DCRADLE_JOIN=OFF compiles each for itself, which proves that every source includes what it uses.
option(CRADLE_JOIN "Compile a few sources of a room, or tests of a folder, at a time" ON)
set(cradle_joined_sources 12)

# cradle_join(TARGET): for the sources that the target has by now.
function(cradle_join target)
    if(NOT CRADLE_JOIN)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    foreach(source ${sources})
        if(source MATCHES "\\.cpp$")
            get_filename_component(room "${source}" DIRECTORY)
            string(REPLACE "${CMAKE_CURRENT_SOURCE_DIR}" "" room "${room}")
            string(MAKE_C_IDENTIFIER "room${room}" room)
            math(EXPR batch "0${count_${room}}")
            math(EXPR count_${room} "${batch} + 1")
            math(EXPR batch "${batch} / ${cradle_joined_sources}")
            set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${room}_${batch}")
        endif()
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
