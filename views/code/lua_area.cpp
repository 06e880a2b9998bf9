// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/lua_area.h"

#include "views/code/left_to_right_painting.h"
#include "views/code/lua_indent.h"
#include "views/code/lua_lexer.h"
#include "views/icons.h"
#include "views/theme.h"

#include <Qsci/qscicommandset.h>

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>

#include <algorithm>

namespace cradle {

namespace {

constexpr int edgeMargin = 0;
constexpr int markMargin = 1;
constexpr int numberMargin = 2;
constexpr int foldMargin = 3;
constexpr int edgeWidth = 4;  ///< px
constexpr int markWidth = 14; ///< px
constexpr int foldWidth = 14; ///< px
constexpr long textGap = 5;   ///< px between margins and text
constexpr int lineSpace = 1;  ///< px below the letters of a line

long toRgb(const QColor &colour)
{
    return colour.red() | colour.green() << 8 | colour.blue() << 16;
}

} // namespace

LuaArea::LuaArea(QWidget *parent)
    : QsciScintilla(parent)
    , m_lexer(new LuaLexer(this))
{
    setLayoutDirection(Qt::LeftToRight);
    setFrameShape(QFrame::NoFrame);
    setUpDocument();
    setTabIndents(true);
    setBackspaceUnindents(true);
    setBraceMatching(SloppyBraceMatch);
    setAutoCompletionSource(AcsNone);
    setCallTipsStyle(CallTipsNone);
    setScrollWidth(1);
    setScrollWidthTracking(true);
    setExtraDescent(lineSpace);
    setAnnotationDisplay(AnnotationIndented);
    setCaretWidth(2);
    setCaretLineVisible(true);
    setCaretLineFrameWidth(1);
    setUpMargins();
    setUpKeys();
    applyLook();
    connect(this, &QsciScintillaBase::SCN_CHARADDED, this, &LuaArea::reindent);
    connect(this, &QsciScintillaBase::SCN_ZOOM, this, &LuaArea::fitMargins);
    connect(this, &QsciScintillaBase::SCN_MODIFIED, this, &LuaArea::noteWriting);
    connect(this, &QsciScintilla::linesChanged, this, &LuaArea::fitMargins);
}

/// What Scintilla keeps with the document, not with the field.
void LuaArea::setUpDocument()
{
    setUtf8(true);
    setEolMode(EolUnix);
    setIndentationsUseTabs(false);
    setIndentationWidth(luaIndent);
    setTabWidth(luaIndent);
}

void LuaArea::paintEvent(QPaintEvent *event)
{
    const LeftToRightPainting painting;
    QsciScintilla::paintEvent(event);
}

void LuaArea::showDocument(const QsciDocument &document)
{
    clearAnnotations();
    setDocument(document);
    setUpDocument();
    setFolding(PlainFoldStyle, foldMargin); // with marks of its own: the look comes after
    applyLook();
}

void LuaArea::setUpMargins()
{
    setMargins(4);
    setMarginType(edgeMargin, SymbolMargin);
    setMarginMarkerMask(edgeMargin, 0);
    setMarginWidth(edgeMargin, edgeWidth);
    setMarginType(markMargin, SymbolMargin);
    setMarginMarkerMask(markMargin,
                        1 << SuspectMark | 1 << ExecutingMark | 1 << ErrorMark | 1 << ChangedMark);
    setMarginType(numberMargin, NumberMargin);
    setMarginMarkerMask(numberMargin, 0);
    setFolding(PlainFoldStyle, foldMargin);
    send(SCI_SETMARGINLEFT, 0, textGap);
    for (const Mark line : {SuspectLine, ExecutingLine, ErrorLine, ChangedLine})
        markerDefine(Background, line);
    markerDefine(LeftRectangle, SuspectMark);
    markerDefine(LeftRectangle, ChangedMark);
    markerDefine(RightTriangle, ExecutingMark);
    markerDefine(Circle, ErrorMark);
}

/// Keys of which nobody expects what they do, or that belong to the window.
void LuaArea::setUpKeys()
{
    for (QsciCommand *command : standardCommands()->commands()) {
        switch (command->command()) {
        case QsciCommand::Redo:
            command->setAlternateKey((Qt::CTRL | Qt::SHIFT | Qt::Key_Z).toCombined());
            break;
        case QsciCommand::LineCut:
        case QsciCommand::LineCopy:
        case QsciCommand::LineDelete:
        case QsciCommand::LineTranspose:
        case QsciCommand::SelectionLowerCase:
        case QsciCommand::SelectionUpperCase:
        case QsciCommand::WordPartLeft:
        case QsciCommand::WordPartLeftExtend:
        case QsciCommand::WordPartRight:
        case QsciCommand::WordPartRightExtend:
        case QsciCommand::EditToggleOvertype:
        case QsciCommand::Formfeed:
        case QsciCommand::ZoomIn:
        case QsciCommand::ZoomOut:
            command->setKey(0);
            command->setAlternateKey(0);
            break;
        default:
            break;
        }
    }
}

void LuaArea::applyLook()
{
    const CodeColours colours = codeColours();
    m_lexer->setLook(colours, numericFont());
    setLexer(m_lexer);
    setMarginsFont(numericFont());
    setMarginsBackgroundColor(colours.background);
    setMarginsForegroundColor(colours.muted);
    setFoldMarginColors(colours.background, colours.background);
    for (unsigned long marker = SC_MARKNUM_FOLDEREND; marker <= SC_MARKNUM_FOLDEROPEN; ++marker) {
        send(SCI_MARKERSETFORE, marker, toRgb(colours.background));
        send(SCI_MARKERSETBACK, marker, toRgb(colours.muted));
    }
    SendScintilla(SCI_MARKERDEFINE, SC_MARKNUM_FOLDER, long(SC_MARK_ARROW));
    SendScintilla(SCI_MARKERDEFINE, SC_MARKNUM_FOLDEROPEN, long(SC_MARK_ARROWDOWN));
    setCaretForegroundColor(colours.text);
    setCaretLineBackgroundColor(colours.currentLine);
    setSelectionBackgroundColor(colours.selection);
    resetSelectionForegroundColor();
    setMatchedBraceBackgroundColor(colours.selection);
    setMatchedBraceForegroundColor(colours.text);
    setUnmatchedBraceBackgroundColor(colours.errorLine);
    setUnmatchedBraceForegroundColor(colours.error);
    const std::pair<Mark, QColor> marks[] = {
        {SuspectLine, colours.suspectLine}, {ExecutingLine, colours.executingLine},
        {ErrorLine, colours.errorLine},     {SuspectMark, colours.suspect},
        {ExecutingMark, colours.executing}, {ErrorMark, colours.error},
        {ChangedLine, colours.suspectLine}, {ChangedMark, colours.suspect}};
    for (const auto &[mark, colour] : marks) {
        setMarkerBackgroundColor(colour, mark);
        setMarkerForegroundColor(colour, mark);
    }
    indicatorDefine(StraightBoxIndicator, matchIndicator);
    QColor match = colours.match;
    match.setAlpha(90);
    setIndicatorForegroundColor(match, matchIndicator);
    setIndicatorDrawUnder(true, matchIndicator);
    fitMargins();
}

void LuaArea::fitMargins()
{
    const int digits = std::max(2, static_cast<int>(QString::number(lines()).size()));
    setMarginWidth(numberMargin, QString(digits, u'8') + u' ');
    setMarginWidth(markMargin, iconSquare(markWidth).width());
    setMarginWidth(foldMargin, iconSquare(foldWidth).width());
}

QRect LuaArea::placeOf(long position) const
{
    const long line = send(SCI_LINEFROMPOSITION, static_cast<unsigned long>(position));
    return {static_cast<int>(send(SCI_POINTXFROMPOSITION, 0, position)),
            static_cast<int>(send(SCI_POINTYFROMPOSITION, 0, position)), 1,
            static_cast<int>(send(SCI_TEXTHEIGHT, static_cast<unsigned long>(line)))};
}

void LuaArea::replaceBytes(long start, long end, const QByteArray &by)
{
    send(SCI_SETTARGETSTART, static_cast<unsigned long>(start));
    send(SCI_SETTARGETEND, static_cast<unsigned long>(end));
    SendScintilla(SCI_REPLACETARGET, static_cast<unsigned long>(by.size()), by.constData());
}

int LuaArea::textLeft() const
{
    int width = 0;
    for (int margin = 0; margin < margins(); ++margin)
        width += marginWidth(margin);
    return width;
}

void LuaArea::setTextSize(int zoom)
{
    zoomTo(std::clamp(zoom, smallestZoom, largestZoom));
}

} // namespace cradle
