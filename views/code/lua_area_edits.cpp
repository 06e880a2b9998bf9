// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/lua_area.h"

#include "views/code/lua_indent.h"

namespace cradle {

// What typing does beyond letters: indentation, ends of blocks, comments.

namespace {

bool isNamePart(char c)
{
    return c == '_' || QChar::isLetterOrNumber(static_cast<unsigned char>(c));
}

} // namespace

/// Ends the line and indents the next.
void LuaArea::breakLine()
{
    beginUndoAction();
    removeSelectedText();
    const QByteArray text = bytes();
    const qsizetype at = cursor();
    qsizetype start = at;
    qsizetype end = at;
    while (start > 0 && text[start - 1] == ' ')
        --start;
    while (end < text.size() && text[end] == ' ')
        ++end;
    const int indent = indentAfter(text.first(at));
    const QByteArray line = '\n' + QByteArray(indent, ' ');
    replaceBytes(static_cast<long>(start), static_cast<long>(end), line);
    SendScintilla(SCI_GOTOPOS, static_cast<long>(start + line.size()));
    endUndoAction();
    SendScintilla(SCI_CHOOSECARETX);
    ensureCursorVisible();
}

/// Brings a line to the indentation of the block that it ends, as soon as it says so.
void LuaArea::reindent(int)
{
    const QByteArray before = bytesBefore();
    const qsizetype start = before.lastIndexOf('\n') + 1;
    const auto line =
        static_cast<unsigned long>(send(SCI_LINEFROMPOSITION, static_cast<unsigned long>(start)));
    std::optional<int> indent = indentOfCloser(before);
    // "end" may turn out to be "endpoint".
    if (!indent && before.size() > start && isNamePart(before.back())
        && indentOfCloser(before.chopped(1)))
        indent = indentAfter(before.first(start));
    if (indent && send(SCI_GETLINEINDENTATION, line) != *indent) {
        const long fromEnd = send(SCI_GETLENGTH) - cursor();
        SendScintilla(SCI_SETLINEINDENTATION, line, long(*indent));
        SendScintilla(SCI_GOTOPOS, send(SCI_GETLENGTH) - fromEnd);
    }
}

/// Makes comments of the selected lines, or code again if all of them are.
void LuaArea::toggleComment()
{
    int from = 0;
    int to = 0;
    int column = 0;
    int endColumn = 0;
    getCursorPosition(&from, &column);
    to = from;
    if (hasSelectedText())
        getSelection(&from, &column, &to, &endColumn);
    if (to > from && endColumn == 0)
        --to;
    bool all = true;
    for (int line = from; line <= to; ++line)
        all = all
              && (text(line).trimmed().startsWith(QLatin1String("--"))
                  || text(line).trimmed().isEmpty());
    beginUndoAction();
    for (int line = from; line <= to; ++line) {
        const int at = indentation(line);
        if (text(line).trimmed().isEmpty())
            continue;
        if (!all) {
            insertAt(QStringLiteral("-- "), line, at);
            continue;
        }
        const int length = text(line).mid(at).startsWith(QLatin1String("-- ")) ? 3 : 2;
        const int start = positionFromLineIndex(line, at);
        SendScintilla(SCI_DELETERANGE, static_cast<unsigned long>(start), long(length));
    }
    endUndoAction();
}

} // namespace cradle
