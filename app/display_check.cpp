// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/display_check.h"

#include <QLibrary>

#include <string_view>

namespace cradle {

namespace {

/// Asks the X server whether it lets us in; true where that cannot be asked.
bool reachesXServer()
{
    // The platform plugin loads the same library; linking to it would bind the program to X11.
    QLibrary xcb(QStringLiteral("xcb"), 1);
    using Connect = void *(*)(const char *, int *);
    using HasError = int (*)(void *);
    using Disconnect = void (*)(void *);
    const auto connect = reinterpret_cast<Connect>(xcb.resolve("xcb_connect"));
    const auto hasError = reinterpret_cast<HasError>(xcb.resolve("xcb_connection_has_error"));
    const auto disconnect = reinterpret_cast<Disconnect>(xcb.resolve("xcb_disconnect"));
    if (!connect || !hasError || !disconnect)
        return true;
    void *connection = connect(nullptr, nullptr);
    const bool reached = hasError(connection) == 0;
    disconnect(connection);
    return reached;
}

} // namespace

QString missingDisplay(int argc, char **argv)
{
    for (int i = 1; i < argc; ++i) {
        // The user chose a platform; Qt says itself if that is wrong.
        const std::string_view argument(argv[i]);
        if (argument == "-platform" || argument == "--platform")
            return {};
    }
    if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM")
        || qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
        return {};
    if (!qEnvironmentVariableIsSet("DISPLAY")) {
        return QStringLiteral(
            "cradle: there is no display (neither DISPLAY nor WAYLAND_DISPLAY is "
            "set). Start it on a desktop, or under Xvfb with \"xvfb-run cradle\"; "
            "cradle-cli and cradle --screenshot need none.");
    }
    if (!reachesXServer()) {
        return QStringLiteral("cradle: the display \"%1\" (from DISPLAY) cannot be reached. Is the "
                              "X server running, and may you use it? cradle-cli and cradle "
                              "--screenshot need none.")
            .arg(qEnvironmentVariable("DISPLAY"));
    }
    return {};
}

} // namespace cradle
