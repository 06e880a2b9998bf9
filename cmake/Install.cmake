# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# `cmake --install build/release --prefix /usr/local` puts the programs where a desktop finds them;
# a double click on NAME.cradle then opens it. Labs, translations, help and MathJax are inside the programs.
include(GNUInstallDirs)
install(TARGETS cradle cradle-cli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}"
        BUNDLE DESTINATION .)

if(UNIX AND NOT APPLE)
    set(resources "${CMAKE_SOURCE_DIR}/resources")
    set(docs "${CMAKE_INSTALL_DATADIR}/doc/cradle")
    install(FILES "${resources}/desktop/cradle.desktop"
            DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
    install(FILES "${resources}/desktop/cradle.metainfo.xml"
            DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo" RENAME org.cradle_lab.cradle.metainfo.xml)
    install(FILES "${resources}/desktop/cradle.xml"
            DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages")
    install(FILES "${resources}/desktop/cradle.svg"
            DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
    install(FILES "${resources}/completions/cradle" "${resources}/completions/cradle-cli"
            DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
    install(FILES "${resources}/packaging/copyright" DESTINATION "${docs}")
    configure_file("${resources}/packaging/changelog.Debian" packaging/changelog.Debian @ONLY)

    # zipped NAME SOURCE FOLDER: installs a file as NAME.gz, without its date, as Debian's policy has it.
    find_program(CRADLE_GZIP gzip)
    function(zipped name source folder)
        set(result "${CMAKE_BINARY_DIR}/packaging/${name}.gz")
        install(CODE "execute_process(COMMAND \"${CRADLE_GZIP}\" -9nc \"${source}\"
                                      OUTPUT_FILE \"${result}\" COMMAND_ERROR_IS_FATAL ANY)")
        install(FILES "${result}" DESTINATION "${folder}")
    endfunction()
    zipped(cradle.1 "${resources}/man/cradle.1" "${CMAKE_INSTALL_MANDIR}/man1")
    zipped(cradle-cli.1 "${resources}/man/cradle-cli.1" "${CMAKE_INSTALL_MANDIR}/man1")
    zipped(changelog "${CMAKE_SOURCE_DIR}/CHANGELOG.md" "${docs}")
    zipped(changelog.Debian "${CMAKE_BINARY_DIR}/packaging/changelog.Debian" "${docs}")
endif()
