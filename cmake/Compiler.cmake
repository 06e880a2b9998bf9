# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# One dialect, one floating point: the same preset gives the same bits from
# GCC and Clang, Debug and Release. So no contraction to fused multiply-add
# and no -ffast-math.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
add_compile_definitions(QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII
                        QT_DISABLE_DEPRECATED_BEFORE=0x060400)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    add_compile_options(-march=x86-64-v2)
endif()
# Steps are computed in model; what is around it need not be unrolled, and compiles faster so.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess) # so that ccache need not unfold precompiled headers
endif()
if(CRADLE_WERROR)
    set(CMAKE_COMPILE_WARNING_AS_ERROR ON)
endif()
if(CRADLE_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
                        -fno-omit-frame-pointer)
    add_compile_definitions(CRADLE_SANITIZED)
    add_link_options(-fsanitize=address,undefined)
endif()

find_program(CRADLE_CCACHE ccache)
if(CRADLE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # Paths count from the source folder, so that one clone's results serve the next. The sloppiness
    # is what precompiled headers ask for; no source uses __DATE__ or __TIME__.
    set(ccache_settings "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}" CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros
        CCACHE_PCH_EXTSUM=1 # see PrecompiledHeaders.cmake
        GLIBC_TUNABLES=glibc.malloc.hugetlb=1) # a fifth of a compiler's time goes into small pages
    set(CMAKE_CXX_COMPILER_LAUNCHER
        env ${ccache_settings} "${CRADLE_CCACHE}")
endif()
# Resources without the times of their files, which differ in every clone.
set(cradle_rcc_options --format-version 1)

find_program(CRADLE_MOLD mold)
if(CRADLE_MOLD)
    add_link_options(-fuse-ld=mold)
endif()
