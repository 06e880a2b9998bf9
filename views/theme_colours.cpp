// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of every Theme.
#include "views/theme.h"

namespace cradle {

const Theme &Theme::lightTheme()
{
    static const Theme light{
        .window = QColor(0xf6f8fa),
        .panel = QColor(0xffffff),
        .border = QColor(0xdfe4ea),
        .text = QColor(0x1a2332),
        .mutedText = QColor(0x5a6675),
        .accent = QColor(0x0f66c2),
        .accentSoft = QColor(0xe5f1fe),
        .scene = QColor(0xf0f8ff),
        .grid = QColor(0xdde7f0),
        .square = QColor(0x1e90ff),
        .along = QColor(0xd47400),
        .across = QColor(0x0b9e72),
        .kinetic = QColor(0x1971c2),
        .potential = QColor(0x7048e8),
        .dissipated = QColor(0x868e96),
        .success = QColor(0x0b7a55),
        .warning = QColor(0x955400),
        .warningSoft = QColor(0xfff8ea),
        .warningBorder = QColor(0xf0d5a0),
        .onAccent = QColor(0xffffff),
        .controlBorder = QColor(0x848f9d),
        .hover = QColor(0xeef2f6),
        .dark = false,
    };
    return light;
}

const Theme &Theme::darkTheme()
{
    static const Theme dark{
        .window = QColor(0x0f141b),
        .panel = QColor(0x171d26),
        .border = QColor(0x2a333f),
        .text = QColor(0xe6ebf2),
        .mutedText = QColor(0x9aa7b6),
        .accent = QColor(0x5aabff),
        .accentSoft = QColor(0x1b2f48),
        .scene = QColor(0x10161d),
        .grid = QColor(0x212b37),
        .square = QColor(0x1e90ff),
        .along = QColor(0xffa94d),
        .across = QColor(0x38d9a9),
        .kinetic = QColor(0x74c0fc),
        .potential = QColor(0x9775fa),
        .dissipated = QColor(0xa3adb8),
        .success = QColor(0x45cf9c),
        .warning = QColor(0xffc078),
        .warningSoft = QColor(0x2b2416),
        .warningBorder = QColor(0x5e4a22),
        .onAccent = QColor(0x08121d),
        .controlBorder = QColor(0x5f6c7e),
        .hover = QColor(0x212a36),
        .dark = true,
    };
    return dark;
}

const Theme &Theme::highContrastTheme()
{
    static const Theme strong{
        .window = QColor(0xffffff),
        .panel = QColor(0xffffff),
        .border = QColor(0x595959),
        .text = QColor(Qt::black),
        .mutedText = QColor(0x2b2b2b),
        .accent = QColor(0x003e9c),
        .accentSoft = QColor(0xd9e8ff),
        .scene = QColor(0xffffff),
        .grid = QColor(0xc4c4c4),
        .square = QColor(0x0047b3),
        .along = QColor(0x804a00),
        .across = QColor(0x00624a),
        .kinetic = QColor(0x00468c),
        .potential = QColor(0x5b21d0),
        .dissipated = QColor(0x6b6b6b),
        .success = QColor(0x00522f),
        .warning = QColor(0x6b3300),
        .warningSoft = QColor(0xfff3d6),
        .warningBorder = QColor(0x6b3300),
        .onAccent = QColor(0xffffff),
        .controlBorder = QColor(Qt::black),
        .hover = QColor(0xe6e6e6),
        .dark = false,
        .textContrast = 7.0,
        .shapeContrast = 4.5,
    };
    return strong;
}

} // namespace cradle
