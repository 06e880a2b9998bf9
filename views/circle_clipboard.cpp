// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/circle_clipboard.h"

#include "model/files/preset_json.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct ClipboardText {
    Q_DECLARE_TR_FUNCTIONS(CircleClipboard)
};

/// Characters; a clipboard can hold anything, and 100,000 circles take half of this.
constexpr qsizetype mostText = 32 * 1024 * 1024;

} // namespace

QString circlesText(const Preset &preset, const std::vector<int> &indices)
{
    Preset part = preset;
    part.fill.reset();
    part.circles.clear();
    for (const int index : indices)
        part.circles.push_back(preset.circles[static_cast<std::size_t>(index)]);
    return QString::fromUtf8(writePreset(part));
}

Result<std::vector<PresetCircle>> circlesFromText(const QString &text)
{
    if (text.trimmed().isEmpty())
        return Error{ClipboardText::tr("The clipboard is empty: copy circles first")};
    if (text.size() > mostText)
        return Error{ClipboardText::tr("The clipboard holds too much text to be circles")};
    const Result<Preset> preset = parsePreset(text.toUtf8());
    if (!preset)
        return Error{
            ClipboardText::tr("The clipboard holds no circles: %1").arg(preset.error().toString())};
    if (preset->circles.empty())
        return Error{ClipboardText::tr("The scene on the clipboard has no circles")};
    return preset->circles;
}

} // namespace cradle
