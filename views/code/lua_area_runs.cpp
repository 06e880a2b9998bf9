// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Words that go from the right, in a field that only knows the left.
#include "views/code/lua_area.h"
#include "views/code/run_marks.h"

namespace cradle {

/// What is typed, pasted or dropped; what Undo brings back has its marks.
void LuaArea::noteWriting(int /*position*/, int kind, const char *text, int length)
{
    const bool isWritten = (kind & SC_MOD_INSERTTEXT) != 0 && (kind & SC_PERFORMED_USER) != 0;
    if (!isWritten || !text || m_marksLater || !needsRunMarks(QString::fromUtf8(text, length)))
        return;
    m_marksLater = true; // Scintilla allows no edit while it tells of one
    QMetaObject::invokeMethod(this, &LuaArea::markRuns, Qt::QueuedConnection);
}

bool LuaArea::beginsRun(const QString &written) const
{
    return !isReadOnly() && needsRunMarks(written)
           && !isWithinRunMarks(QString::fromUtf8(bytesBefore()));
}

/// Only in the lines that lack some; the cursor stays between its letters.
void LuaArea::markRuns()
{
    m_marksLater = false;
    if (isReadOnly() || withRunMarks(text()) == text())
        return;
    SendScintilla(SCI_BEGINUNDOACTION);
    for (int line = 0; line < lines(); ++line) {
        const QString now = text(line);
        const QString marked = withRunMarks(now);
        if (marked == now)
            continue;
        const long start = send(SCI_POSITIONFROMLINE, static_cast<unsigned long>(line));
        const long at = cursor() - start;
        const bool isHere = at >= 0 && at <= now.toUtf8().size();
        const QString before = QString::fromUtf8(now.toUtf8().left(at));
        replaceBytes(start, start + now.toUtf8().size(), marked.toUtf8());
        if (!isHere)
            continue;
        // As many letters stand before it as did, marks left out; what is typed next joins them.
        const qsizetype letters = withoutRunMarks(before).size();
        qsizetype end = 0;
        for (qsizetype met = 0; end < marked.size() && met < letters; ++end)
            met += withoutRunMarks(marked.mid(end, 1)).size();
        send(SCI_GOTOPOS, static_cast<unsigned long>(start + marked.left(end).toUtf8().size()));
    }
    SendScintilla(SCI_ENDUNDOACTION);
}

} // namespace cradle
