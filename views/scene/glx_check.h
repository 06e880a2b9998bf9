// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace cradle {

/// Whether the X server offers GLX, but no driver of this machine has a visual for it. Qt ends the
/// program when it is asked for an OpenGL context there (qFatal in QGLXContext), instead of saying
/// that there is none. False on any other display, and where it cannot be found out.
[[nodiscard]] bool lacksGlxVisual();

} // namespace cradle
