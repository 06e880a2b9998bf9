# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The programs contain our libraries; some three hundred tests would contain them again. So tests link the
# same objects as shared libraries: a test is small, and none is linked anew when a library's source changes.

# cradle_share(NAME): cradle_shared_NAME, of the objects and resources of cradle_NAME. What cradle_NAME links of
# ours must have been shared before it.
function(cradle_share name)
    get_target_property(linked cradle_${name} LINK_LIBRARIES)
    get_target_property(offered cradle_${name} INTERFACE_LINK_LIBRARIES)
    set(resources ${offered})
    list(FILTER resources INCLUDE REGEX "^cradle_[a-z]+_resources_[0-9]+$")
    list(TRANSFORM resources REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
    list(FILTER offered INCLUDE REGEX "^(cradle_[a-z]+|Qt6::[A-Za-z]+|.*[.]so)$") # not what is $<LINK_ONLY:…>
    # The archive of Lua is not made for a shared library.
    list(TRANSFORM linked REPLACE ".*/liblua[^/]*\\.a$" PkgConfig::LUA)
    list(TRANSFORM linked REPLACE "^cradle_(model|tasks|views|language)$" "cradle_shared_\\1")
    list(TRANSFORM offered REPLACE "^cradle_" "cradle_shared_")

    add_library(cradle_shared_${name} SHARED $<TARGET_OBJECTS:cradle_${name}> ${resources})
    target_include_directories(cradle_shared_${name} INTERFACE "${CMAKE_SOURCE_DIR}")
    target_link_libraries(cradle_shared_${name} PRIVATE ${linked} INTERFACE ${offered})
    set_target_properties(cradle_shared_${name} PROPERTIES LINKER_LANGUAGE CXX AUTOMOC OFF
        LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests/lib")
endfunction()
