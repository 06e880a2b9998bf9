// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/code_editor.h"
#include "views/code/lua_area.h"

#include <vector>

namespace cradle {

namespace {

using Area = QsciScintillaBase;

/// A match, in bytes.
struct Match {
    long start = 0;
    long end = 0;
};

std::vector<Match> matchesIn(const LuaArea &area, const SearchTerm &term)
{
    std::vector<Match> matches;
    const QByteArray wanted = term.text.toUtf8();
    if (wanted.isEmpty())
        return matches;
    const int flags = (term.matchCase ? Area::SCFIND_MATCHCASE : 0)
                      | (term.wholeWord ? Area::SCFIND_WHOLEWORD : 0);
    area.send(Area::SCI_SETSEARCHFLAGS, static_cast<unsigned long>(flags));
    const long length = area.send(Area::SCI_GETLENGTH);
    long from = 0;
    while (from < length) {
        area.send(Area::SCI_SETTARGETSTART, static_cast<unsigned long>(from));
        area.send(Area::SCI_SETTARGETEND, static_cast<unsigned long>(length));
        const long found =
            area.SendScintilla(Area::SCI_SEARCHINTARGET, static_cast<unsigned long>(wanted.size()),
                               wanted.constData());
        if (found < 0)
            break;
        matches.push_back({found, area.send(Area::SCI_GETTARGETEND)});
        from = matches.back().end;
    }
    return matches;
}

long selectionStart(const LuaArea &area)
{
    return area.send(Area::SCI_GETSELECTIONSTART);
}

long selectionEnd(const LuaArea &area)
{
    return area.send(Area::SCI_GETSELECTIONEND);
}

/// The number, from 1, of the match that is selected.
int selectedMatch(const LuaArea &area, const std::vector<Match> &matches)
{
    for (std::size_t i = 0; i < matches.size(); ++i) {
        if (matches[i].start == selectionStart(area) && matches[i].end == selectionEnd(area))
            return static_cast<int>(i) + 1;
    }
    return 0;
}

void select(LuaArea &area, const Match &match)
{
    area.ensureLineVisible(static_cast<int>(
        area.send(Area::SCI_LINEFROMPOSITION, static_cast<unsigned long>(match.start))));
    area.send(Area::SCI_SETSEL, static_cast<unsigned long>(match.start), match.end);
}

} // namespace

SearchPlace CodeEditor::highlight(const SearchTerm &term)
{
    m_area->send(Area::SCI_SETINDICATORCURRENT, LuaArea::matchIndicator);
    m_area->send(Area::SCI_INDICATORCLEARRANGE, 0, m_area->send(Area::SCI_GETLENGTH));
    const std::vector<Match> matches = matchesIn(*m_area, term);
    for (const Match &match : matches)
        m_area->send(Area::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(match.start),
                     match.end - match.start);
    return {selectedMatch(*m_area, matches), static_cast<int>(matches.size())};
}

SearchPlace CodeEditor::findHere(const SearchTerm &term)
{
    m_area->send(Area::SCI_SETEMPTYSELECTION, static_cast<unsigned long>(selectionStart(*m_area)));
    const std::vector<Match> matches = matchesIn(*m_area, term);
    if (matches.empty())
        return {};
    std::size_t i = 0;
    while (i < matches.size() && matches[i].start < selectionStart(*m_area))
        ++i;
    i %= matches.size();
    select(*m_area, matches[i]);
    return {static_cast<int>(i) + 1, static_cast<int>(matches.size())};
}

SearchPlace CodeEditor::findNext(const SearchTerm &term, bool forward)
{
    const std::vector<Match> matches = matchesIn(*m_area, term);
    if (matches.empty())
        return {};
    const std::size_t count = matches.size();
    std::size_t i = 0;
    if (forward) {
        while (i < count && matches[i].start < selectionEnd(*m_area))
            ++i;
    } else {
        i = count;
        while (i > 0 && matches[i - 1].end > selectionStart(*m_area))
            --i;
        i += count - 1;
    }
    i %= count;
    select(*m_area, matches[i]);
    return {static_cast<int>(i) + 1, static_cast<int>(count)};
}

SearchPlace CodeEditor::replaceNext(const SearchTerm &term, const QString &replacement)
{
    const std::vector<Match> matches = matchesIn(*m_area, term);
    if (isReadOnly() || selectedMatch(*m_area, matches) == 0)
        return findHere(term);
    const long start = selectionStart(*m_area);
    const QByteArray by = replacement.toUtf8();
    m_area->replaceBytes(start, selectionEnd(*m_area), by);
    m_area->send(Area::SCI_SETEMPTYSELECTION, static_cast<unsigned long>(start + by.size()));
    return findHere(term);
}

int CodeEditor::replaceAll(const SearchTerm &term, const QString &replacement)
{
    const std::vector<Match> matches = matchesIn(*m_area, term);
    if (isReadOnly() || matches.empty())
        return 0;
    m_area->beginUndoAction();
    // From the end, so that the places before stay true.
    for (auto match = matches.rbegin(); match != matches.rend(); ++match)
        m_area->replaceBytes(match->start, match->end, replacement.toUtf8());
    m_area->endUndoAction();
    return static_cast<int>(matches.size());
}

QString CodeEditor::selectedText() const
{
    return m_area->selectedText();
}

void CodeEditor::selectAll()
{
    m_area->selectAll();
}

bool CodeEditor::canUndo() const
{
    return m_area->isUndoAvailable();
}

bool CodeEditor::canRedo() const
{
    return m_area->isRedoAvailable();
}

void CodeEditor::undo()
{
    m_area->undo();
}

void CodeEditor::redo()
{
    m_area->redo();
}

int CodeEditor::zoom() const
{
    return static_cast<int>(m_area->send(Area::SCI_GETZOOM));
}

void CodeEditor::setZoom(int steps)
{
    m_area->setTextSize(steps);
}

} // namespace cradle
