// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/markdown_view.h"

#include "views/bound_units.h"
#include "views/focus_ring.h"
#include "views/formula_renderer.h"
#include "views/list_numbers.h"
#include "views/markdown_style.h"
#include "views/picture_objects.h"
#include "views/spoken_formula.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QEvent>
#include <QMimeData>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextList>

namespace cradle {

namespace {

constexpr int formulaProperty = PictureObjects::indexProperty + 1; ///< index into m_formulas

/// CommonMark without HTML, and tables: MD_FLAG_TABLES of md4c, to which Qt hands it on.
constexpr QTextDocument::MarkdownFeatures features =
    QTextDocument::MarkdownFeatures::fromInt(QTextDocument::MarkdownNoHTML | 0x0100);

// At equal x-height, the capitals and digits of TeX's font stand above those of most others, so
// formulas are a little smaller than that.
constexpr double formulaScale = 0.94;

} // namespace

MarkdownView::MarkdownView(QWidget *parent, FormulaRenderer *renderer)
    : QTextBrowser(parent)
    , m_renderer(renderer ? renderer : new FormulaRenderer(this))
    , m_pictures(new PictureObjects(this))
{
    setFrameShape(QFrame::NoFrame);
    ringFocus(this);
    setOpenLinks(false);
    setUndoRedoEnabled(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    document()->documentLayout()->registerHandler(PictureObjects::objectType, m_pictures);
    connect(this, &QTextBrowser::anchorClicked, this, &MarkdownView::followLink);
    connect(m_renderer, &FormulaRenderer::ready, this, &MarkdownView::replaceFormulas);
}

void MarkdownView::setMarkdown(const QString &text, const QUrl &folder)
{
    m_markdown = text;
    m_folder =
        folder.scheme() == QLatin1String("qrc") ? u':' + folder.path() : folder.toLocalFile();
    rebuild();
    verticalScrollBar()->setValue(0);
}

void MarkdownView::setEmbedded(bool embedded)
{
    m_embedded = embedded;
    setStyleSheet(embedded ? QStringLiteral("background: transparent;") : QString());
    rebuild();
}

void MarkdownView::rebuild()
{
    const int scrolled = verticalScrollBar()->value();
    const FormulaText text = findFormulas(m_markdown);
    document()->clear();
    m_pictures->clear();
    m_formulas.clear();
    for (const FormulaSource &source : text.formulas)
        m_formulas.push_back({source, {}});

    document()->setDefaultFont(font());
    document()->setMarkdown(markListNumbers(text.markdown), features);
    applyListNumbers(document());
    bindUnits(document());
    styleMarkdown(document(), palette().color(QPalette::Text));
    if (m_embedded)
        document()->setDocumentMargin(0);
    placeObjects();
    verticalScrollBar()->setValue(scrolled);
}

QString MarkdownView::spokenText() const
{
    const FormulaText text = findFormulas(m_markdown);
    QTextDocument plain;
    plain.setMarkdown(text.markdown, QTextDocument::MarkdownNoHTML);
    QString said = plain.toPlainText();
    for (std::size_t i = 0; i < text.formulas.size(); ++i) {
        const FormulaSource &formula = text.formulas[i];
        said.replace(QStringLiteral("\uE000%1\uE001").arg(i),
                     formula.before + spokenFormula(formula.tex) + formula.after);
    }
    return said.replace(QChar::ObjectReplacementCharacter, tr("(a picture)"));
}

void MarkdownView::placeObjects()
{
    static const QRegularExpression mark(QString::fromUtf16(FormulaText::markPattern) + u'|'
                                         + QChar(QChar::ObjectReplacementCharacter));
    for (QTextCursor cursor = document()->find(mark, 0); !cursor.isNull();
         cursor = document()->find(mark, cursor)) {
        const QTextCharFormat format = cursor.charFormat();
        if (format.isImageFormat())
            placeFigure(cursor);
        const QString number = mark.match(cursor.selectedText()).captured(1);
        if (number.isEmpty() || number.toULongLong() >= m_formulas.size())
            continue; // a mark may also be a character reference such as &#xE000;
        Placed &formula = m_formulas.at(number.toUInt());
        formula.format = format;
        if (format.fontFixedPitch()) {
            cursor.insertText(formula.source.markdown);
            continue;
        }
        if (formula.source.display)
            isolate(cursor);
        showFormula(cursor, number.toInt());
    }
}

/// Gives the selected formula a centred block of its own, unless it starts a list item.
void MarkdownView::isolate(QTextCursor &cursor)
{
    const QTextBlock block = cursor.block();
    const QString text = block.text();
    int start = cursor.selectionStart() - block.position();
    int end = cursor.selectionEnd() - block.position();
    while (start > 0 && text[start - 1] == u' ')
        --start;
    while (end < text.size() && text[end] == u' ')
        ++end;
    if (start == 0 && block.textList())
        return;
    QTextBlockFormat format = block.blockFormat();
    if (const QTextList *list = block.textList()) {
        format.setObjectIndex(-1);
        format.setIndent(list->format().indent());
    }
    cursor.setPosition(block.position() + start);
    cursor.setPosition(block.position() + end, QTextCursor::KeepAnchor);
    cursor.removeSelectedText();
    if (end < text.size()) {
        cursor.insertBlock(format);
        cursor.movePosition(QTextCursor::Left);
    }
    if (start > 0)
        cursor.insertBlock(format);
    format.setAlignment(Qt::AlignHCenter);
    cursor.setBlockFormat(format);
}

/// Replaces the selection by the formula: typeset if that is known, else as its TeX.
void MarkdownView::showFormula(QTextCursor &cursor, int index)
{
    const auto &[source, around] = m_formulas[size_t(index)];
    const QFont textFont = around.font().resolve(document()->defaultFont());
    const Formula *formula = m_renderer->known(source.tex, source.display);
    if (!formula)
        m_renderer->request(source.tex, source.display);

    QTextCharFormat format = around;
    format.setProperty(formulaProperty, index);
    format.setProperty(QTextFormat::ImageAltText, source.tex);
    if (formula && formula->state == Formula::State::Ready) {
        const double ex = QFontMetricsF(textFont).xHeight() * formulaScale;
        Picture picture;
        picture.svg = formula->svg;
        picture.size = QSizeF(formula->width, formula->height) * ex;
        picture.markdown = source.markdown;
        picture.before = source.before;
        picture.after = source.after;
        picture.fromRight = source.fromRight;
        picture.font = textFont;
        return m_pictures->insertAtDepth(cursor, format, picture, formula->depth * ex);
    }
    format = codeFormat(format, fontSize(textFont));
    format.setFontItalic(true);
    QString text = source.tex.simplified();
    if (formula)
        format.setToolTip(formula->error);
    if (formula && formula->state == Formula::State::Broken) {
        const bool dark = palette().color(QPalette::Base).lightness() < 128;
        format.setForeground(QColor(dark ? 0xff8a80 : 0xb3261e));
        text += QStringLiteral(" (%1)").arg(formula->error);
    }
    if (source.fromRight)
        text = QChar(0x2066) + text + QChar(0x2069);
    cursor.insertText(source.before + text + source.after, format);
}

void MarkdownView::replaceFormulas(const QString &tex, bool display)
{
    for (QTextCursor &span : PictureObjects::spansOf(document())) {
        const QTextCharFormat format = span.charFormat();
        if (!format.hasProperty(formulaProperty) || m_pictures->find(format))
            continue;
        const int index = format.intProperty(formulaProperty);
        const FormulaSource &source = m_formulas.at(size_t(index)).source;
        if (source.tex == tex && source.display == display)
            showFormula(span, index);
    }
}

void MarkdownView::placeFigure(QTextCursor &cursor)
{
    const QTextImageFormat image = cursor.charFormat().toImageFormat();
    const QString alt = image.property(QTextFormat::ImageAltText).toString();
    QTextCharFormat format;
    Picture picture;
    picture.markdown = QStringLiteral("![%1](%2)").arg(alt, image.name());
    const QString refusal = PictureObjects::read(m_folder, image.name(), picture);
    if (!refusal.isEmpty()) {
        format.setFontItalic(true);
        return cursor.insertText(QStringLiteral("[%1: %2]").arg(alt, refusal), format);
    }
    if (cursor.block().length() == 2) { // itself and the end of the block
        QTextBlockFormat block = cursor.blockFormat();
        block.setAlignment(Qt::AlignHCenter);
        cursor.setBlockFormat(block);
    }
    format.setProperty(QTextFormat::ImageAltText, alt);
    format.setToolTip(image.stringProperty(QTextFormat::ImageTitle));
    m_pictures->insert(cursor, format, picture);
}

bool MarkdownView::isComplete() const
{
    return m_renderer->isIdle();
}

QMimeData *MarkdownView::createMimeDataFromSelection() const
{
    return m_pictures->copy(textCursor());
}

void MarkdownView::changeEvent(QEvent *event)
{
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange)
        rebuild();
}

void MarkdownView::followLink(const QUrl &link)
{
    if (link.scheme() == QLatin1String("step"))
        emit stepRequested(link.path());
    else if (link.scheme() == QLatin1String("http") || link.scheme() == QLatin1String("https"))
        QDesktopServices::openUrl(link);
}

} // namespace cradle
