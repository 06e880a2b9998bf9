// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/glx_check.h"

#include <QGuiApplication>
#include <QLibrary>

#include <type_traits>

namespace cradle {

#if QT_CONFIG(xcb)
namespace {

// As in GL/glx.h.
constexpr int glxRgba = 4;
constexpr int glxDrawableType = 0x8010;
constexpr int glxRenderType = 0x8011;
constexpr int glxWindowBit = 1;
constexpr int glxRgbaBit = 1;

/// The functions of GLX and Xlib that tell it. Qt's platform plugin loads the same libraries;
/// linking to them would bind the program to X11.
struct Glx {
    Glx()
    {
        QLibrary x11(QStringLiteral("X11"), 6);
        // All vendors' drivers stand behind this one; without it, in libGL itself.
        QLibrary gl(QStringLiteral("GLX"), 0);
        if (!gl.load())
            gl.setFileNameAndVersion(QStringLiteral("GL"), 1);
        const auto take = [](QLibrary &library, const char *name, auto &function) {
            function = reinterpret_cast<std::decay_t<decltype(function)>>(library.resolve(name));
            return function != nullptr;
        };
        complete = take(x11, "XDefaultScreen", defaultScreen) && take(x11, "XFree", free)
                   && take(gl, "glXQueryExtension", queryExtension)
                   && take(gl, "glXChooseFBConfig", chooseConfigs)
                   && take(gl, "glXChooseVisual", chooseVisual);
    }

    bool complete = false;
    int (*defaultScreen)(Display *) = nullptr;
    int (*free)(void *) = nullptr;
    int (*queryExtension)(Display *, int *, int *) = nullptr;
    void *(*chooseConfigs)(Display *, int, const int *, int *) = nullptr;
    void *(*chooseVisual)(Display *, int, int *) = nullptr;
};

} // namespace

bool lacksGlxVisual()
{
    const auto *x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
    Display *display = x11 ? x11->display() : nullptr;
    // Who asks for EGL has asked for another way than this one.
    if (!display || qgetenv("QT_XCB_GL_INTEGRATION") == "xcb_egl")
        return false;
    const Glx glx;
    if (!glx.complete || !glx.queryExtension(display, nullptr, nullptr))
        return false;
    const int screen = glx.defaultScreen(display);
    const int wantedConfig[] = {glxRenderType, glxRgbaBit, glxDrawableType, glxWindowBit, 0};
    int count = 0;
    void *found = glx.chooseConfigs(display, screen, wantedConfig, &count);
    if (!found) {
        int wantedVisual[] = {glxRgba, 0};
        found = glx.chooseVisual(display, screen, wantedVisual);
    }
    if (found)
        glx.free(found);
    return !found;
}
#else
bool lacksGlxVisual()
{
    return false;
}
#endif

} // namespace cradle
