# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# `cmake --install build/release --prefix /usr/local` puts the programs where a desktop finds them;
# a double click on NAME.cradle then opens it.
include(GNUInstallDirs)
install(TARGETS cradle cradle-cli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(FILES "${CMAKE_SOURCE_DIR}/resources/desktop/cradle.desktop"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES "${CMAKE_SOURCE_DIR}/resources/desktop/cradle.xml"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages")
install(FILES "${CMAKE_SOURCE_DIR}/resources/desktop/cradle.svg"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
