# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# What `cpack` makes of a build: a Debian package on Linux (by tools/package, which checks it as well), an
# installer on Windows, a disk image on macOS. The latter two were never tried: see docs/packaging.md.
set(CPACK_PACKAGE_NAME cradle)
set(CPACK_PACKAGE_VENDOR "The Cradle authors")
set(CPACK_PACKAGE_CONTACT "The Cradle authors <maintainers@cradle.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGE_INSTALL_DIRECTORY Cradle)
set(CPACK_PACKAGE_EXECUTABLES cradle Cradle)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
# Only the two programs belong into a package; tests and benchmarks need not be built for it.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

if(WIN32)
    set(CPACK_GENERATOR NSIS)
    set(CPACK_NSIS_DISPLAY_NAME Cradle)
    set(CPACK_NSIS_MUI_ICON "${CMAKE_SOURCE_DIR}/resources/desktop/cradle.ico")
    set(CPACK_NSIS_INSTALLED_ICON_NAME "bin\\cradle.exe")
    set(CPACK_NSIS_ENABLE_UNINSTALL_BEFORE_INSTALL ON)
elseif(APPLE)
    set(CPACK_GENERATOR DragNDrop)
else()
    set(CPACK_GENERATOR DEB)
    set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
    set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
        GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE) # whatever the umask
    set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
    set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
    set(CPACK_DEBIAN_PACKAGE_SECTION education)
    set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
    # The libraries that the programs link are found by dpkg-shlibdeps; the plugins of Qt that are loaded
    # and the processor that the build asks for (-march=x86-64-v2) are not.
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
    if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
        set(CPACK_DEBIAN_PACKAGE_DEPENDS "qt6-qpa-plugins, sse4.2-support")
    else()
        set(CPACK_DEBIAN_PACKAGE_DEPENDS "qt6-qpa-plugins")
    endif()
    set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
        "bubblewrap, fonts-inter, fonts-jetbrains-mono, libgl1-mesa-dri, libpulse0, qt6-translations-l10n")
    set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Two circles in a square come to life in seventeen steps: motion, bouncing off
walls, gravity, Euler and symplectic Euler side by side, glancing collisions,
masses, restitution. Students read a step, write a few lines of Lua, watch the
scene and the charts of momentum and energy, and check what they wrote.
.
cradle is the window, for students and for those who write labs; cradle-cli
judges programs, labs and whole classes without a display.")
endif()
include(CPack)
