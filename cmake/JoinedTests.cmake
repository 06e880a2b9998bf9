# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Some ten tests of a folder are one program: most of a compiler's work on a test is to read what it includes and
# to make of Qt's templates what every other test makes of them, too. tests/test_NAME is a link to the program that
# holds the test, and the target test_NAME builds it. With -DCRADLE_JOIN=OFF each test is a program of its own, as are
# always those that replace what all of a program share.
set(cradle_joined_tests 10)
set(cradle_lone_tests test_no_allocation)

# cradle_test_program(PROGRAM FOLDER SOURCE...)
function(cradle_test_program program folder)
    set(moc_folder "${CMAKE_CURRENT_BINARY_DIR}/moc")
    foreach(source ${ARGN})
        get_filename_component(name "${source}" NAME_WE)
        set(moc "${moc_folder}/${name}.moc")
        add_custom_command(OUTPUT "${moc}" COMMAND Qt6::moc "${source}" -o "${moc}"
                           DEPENDS "${source}" COMMENT "moc ${name}" VERBATIM)
        list(APPEND mocs "${moc}")
    endforeach()
    set(compiled ${ARGN})
    if(NOT "${program}" STREQUAL "${name}")
        set(compiled "${CMAKE_CURRENT_BINARY_DIR}/${program}.cpp")
        set(join "${CMAKE_SOURCE_DIR}/tests/tools/join-tests")
        add_custom_command(OUTPUT "${compiled}"
            COMMAND "${join}" "${CMAKE_SOURCE_DIR}" "${moc_folder}" "${compiled}" ${ARGN}
            DEPENDS "${join}" ${ARGN} ${mocs} COMMENT "Joining ${program}" VERBATIM)
    endif()
    add_executable(${program} ${compiled} ${mocs})
    if(NOT "${program}" STREQUAL "${name}" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # It takes what is included for a header, which others would include, too.
        target_compile_options(${program} PRIVATE -Wno-subobject-linkage)
    endif()
    target_include_directories(${program} PRIVATE "${moc_folder}")
    target_link_libraries(${program} PRIVATE cradle_test_${folder})
    cradle_precompile_as(${program} cradle_test_${folder})
    set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
endfunction()

# cradle_test_programs(FOLDER SOURCE...): which tests are joined follows from their names, so that a new one moves
# no other (but where there are ten more of them).
function(cradle_test_programs folder)
    list(LENGTH ARGN count)
    math(EXPR last "${count} / ${cradle_joined_tests}")
    foreach(source ${ARGN})
        get_filename_component(name "${source}" NAME_WE)
        if(NOT CRADLE_JOIN OR name IN_LIST cradle_lone_tests)
            if(IS_SYMLINK "${CMAKE_BINARY_DIR}/tests/${name}") # left by a test that was joined
                file(REMOVE "${CMAKE_BINARY_DIR}/tests/${name}")
            endif()
            cradle_test_program(${name} ${folder} "${source}")
            continue()
        endif()
        string(MD5 place "${name}")
        string(SUBSTRING "${place}" 0 6 place)
        math(EXPR place "0x${place} % (${last} + 1)")
        list(APPEND sources_${place} "${source}")
        file(CREATE_LINK tests_of_${folder}_${place} "${CMAKE_BINARY_DIR}/tests/${name}" SYMBOLIC)
        add_custom_target(${name} DEPENDS tests_of_${folder}_${place})
    endforeach()
    foreach(place RANGE ${last})
        if(sources_${place})
            cradle_test_program(tests_of_${folder}_${place} ${folder} ${sources_${place}})
        endif()
    endforeach()
endfunction()
