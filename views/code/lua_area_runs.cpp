// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Words that go from the right, in a field that only knows the left.
#include "views/code/lua_area.h"
#include "views/code/run_marks.h"

#include <QClipboard>
#include <QDropEvent>
#include <QGuiApplication>
#include <QMimeData>

namespace cradle {

/// What is typed within words; what is undone has its marks.
void LuaArea::noteWriting(int /*position*/, int kind, const char *text, int length)
{
    const bool isWritten = (kind & SC_MOD_INSERTTEXT) != 0 && (kind & SC_PERFORMED_USER) != 0;
    if (!isWritten || !text || m_marksLater || !needsRunMarks(QString::fromUtf8(text, length)))
        return;
    m_marksLater = true; // Scintilla allows no edit while it tells of one
    QMetaObject::invokeMethod(this, &LuaArea::markRuns, Qt::QueuedConnection);
}

/// Words from the right that come from \p source and the marks round them are one step of Undo.
/// \param write  takes them in
void LuaArea::takeIn(const QMimeData *source, const std::function<void()> &write)
{
    if (isReadOnly() || !source || !needsRunMarks(source->text()))
        return write();
    SendScintilla(SCI_BEGINUNDOACTION);
    write();
    markRuns();
    SendScintilla(SCI_ENDUNDOACTION);
}

void LuaArea::paste()
{
    takeIn(QGuiApplication::clipboard()->mimeData(), [this] { QsciScintilla::paste(); });
}

void LuaArea::dropEvent(QDropEvent *event)
{
    takeIn(event->mimeData(), [this, event] { QsciScintilla::dropEvent(event); });
}

/// On X11 the middle button puts in what is selected somewhere.
void LuaArea::mouseReleaseEvent(QMouseEvent *event)
{
    const QClipboard *clipboard = QGuiApplication::clipboard();
    const bool pastes = event->button() == Qt::MiddleButton && clipboard->supportsSelection();
    takeIn(pastes ? clipboard->mimeData(QClipboard::Selection) : nullptr,
           [this, event] { QsciScintilla::mouseReleaseEvent(event); });
}

/// What is copied is for others, who have no use for marks.
QMimeData *LuaArea::toMimeData(const QByteArray &text, bool rectangular) const
{
    return QsciScintilla::toMimeData(withoutRunMarks(QString::fromUtf8(text)).toUtf8(),
                                     rectangular);
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
