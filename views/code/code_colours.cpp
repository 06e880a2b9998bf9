// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/code_colours.h"

#include "views/theme.h"

namespace cradle {

namespace {

QColor over(const QColor &top, const QColor &bottom, float share)
{
    return QColor::fromRgbF(share * top.redF() + (1.0F - share) * bottom.redF(),
                            share * top.greenF() + (1.0F - share) * bottom.greenF(),
                            share * top.blueF() + (1.0F - share) * bottom.blueF());
}

} // namespace

CodeColours codeColours()
{
    const Theme &t = theme();
    CodeColours c;
    c.background = t.panel;
    c.currentLine = over(t.text, t.panel, 0.16F);
    c.selection = over(t.accent, t.panel, t.dark ? 0.3F : 0.2F);
    c.suspectLine = over(t.along, t.panel, 0.16F);
    c.executingLine = over(t.accent, t.panel, 0.14F);
    c.errorLine = over(QColor(0xe03131), t.panel, t.dark ? 0.2F : 0.1F);
    const auto readable = [&c](QColor colour) {
        for (const QColor &behind :
             {c.background, c.suspectLine, c.executingLine, c.errorLine, c.selection})
            colour = readableOn(colour, behind);
        return colour;
    };
    c.text = t.text;
    c.muted = readable(t.mutedText);
    c.keyword = readable(QColor(t.dark ? 0xc9a2f5 : 0x8a3fb0));
    c.constant = readable(t.success);
    c.string = readable(QColor(t.dark ? 0xffb27a : 0xb1560f));
    c.call = readable(t.accent);
    c.circle1 = readable(QColor(0x1e90ff));
    c.circle2 = readable(QColor(0xe03131));
    c.error = readable(QColor(t.dark ? 0xff8080 : 0xd02525));
    c.suspect = t.along;
    c.executing = t.accent;
    c.match = t.along;
    return c;
}

} // namespace cradle
