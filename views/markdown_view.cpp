// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "views/markdown_view.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFontDatabase>
#include <QImageReader>
#include <QMimeData>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextFrame>

namespace cradle {

namespace {

constexpr int formulaProperty = PictureObjects::indexProperty + 1;  ///< index into m_formulas

// Distances in units of the font size.
constexpr double lineDistance = 0.22;  ///< between lines, on top of the font's own: 135 % for most
constexpr double paragraphGap = 0.6;
constexpr double headingGap = 1.1;
constexpr double itemGap = 0.2;
constexpr double listIndent = 1.5;
constexpr double margin = 1.0;
constexpr double codeScale = 0.92;
constexpr float codeTint = 0.07F;  ///< share of the text's colour in the background of code

// TeX's letters are wide and light next to those of user-interface fonts: at equal x-height its
// capitals and digits would stand above the text's, so formulas are a little smaller than that.
constexpr double formulaScale = 0.94;

/// Font size in px; QFont itself knows it in either points or pixels.
double fontSize(const QFont &font)
{
    return QFontInfo(font).pixelSize();
}

QTextCharFormat codeFormat(QTextCharFormat format, double size)
{
    format.clearProperty(QTextFormat::FontPointSize);
    format.setProperty(QTextFormat::FontPixelSize, qRound(codeScale * size));
    format.setFontFamilies(
        {"JetBrains Mono", QFontDatabase::systemFont(QFontDatabase::FixedFont).family()});
    return format;
}

/// `font` in the size whose descent is at least `depth` px. QTextDocument puts an object with
/// AlignBaseline as far below the baseline as the descent of its character format's font: the
/// only way to say how deep an object reaches.
QFont fontWithDescent(QFont font, double depth)
{
    constexpr int largest = 1000;  // px, for fonts that claim to have no descent
    for (int size = 1; size < largest; ++size) {
        font.setPixelSize(size);
        if (QFontMetrics(font).descent() >= depth)
            break;
    }
    return font;
}

bool isCode(const QTextBlock &block)
{
    return block.blockFormat().hasProperty(QTextFormat::BlockCodeLanguage);
}

/// Selections of each stretch of text in one format. They keep their place during edits.
std::vector<QTextCursor> spansOf(QTextDocument *document)
{
    std::vector<QTextCursor> spans;
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            QTextCursor span(document);
            span.setPosition(it.fragment().position());
            span.setPosition(span.position() + it.fragment().length(), QTextCursor::KeepAnchor);
            spans.push_back(span);
        }
    }
    return spans;
}

/// Finds the file that a picture's `name` means in `folder`, and reads it.
/// \return why it may not or cannot be shown, or nothing
QString readPicture(const QString &folder, const QString &name, Picture &picture)
{
    static const QRegularExpression elsewhere("^([A-Za-z][A-Za-z0-9+.-]*:|//)");
    static const QRegularExpression reference(R"(<image\b[^>]*href\s*=\s*["'](?!data:))");
    const QString path = QUrl::fromPercentEncoding(name.toUtf8());
    const QFileInfo file(folder + '/' + path);
    // A symbolic link may lead out of the folder, too.
    const QString home = QFileInfo(folder).canonicalFilePath() + '/';
    if (path.contains(elsewhere))
        return MarkdownView::tr("pictures from elsewhere are not loaded");
    if (path.startsWith('/') || path.startsWith(':') || path.contains('\\')
        || path.split('/').contains("..")
        || (file.exists() && !file.canonicalFilePath().startsWith(home)))
        return MarkdownView::tr("the picture must be in the folder of the instructions");
    QFile content(file.filePath());
    if (folder.isEmpty() || !file.isFile() || !content.open(QIODevice::ReadOnly))
        return MarkdownView::tr("there is no picture %1").arg(path);
    if (file.suffix().compare("svg", Qt::CaseInsensitive) == 0) {
        picture.svg = content.readAll();
        picture.size = QSvgRenderer(picture.svg).defaultSize();
        if (QString::fromUtf8(picture.svg).contains(reference))
            return MarkdownView::tr("the picture refers to another file");
    } else {
        picture.image = QImageReader(&content).read();
        picture.size = picture.image.size();
    }
    return picture.size.isEmpty() ? MarkdownView::tr("the picture cannot be read") : QString();
}

} // namespace

MarkdownView::MarkdownView(QWidget *parent, FormulaRenderer *renderer)
    : QTextBrowser(parent),
      m_renderer(renderer ? renderer : new FormulaRenderer(this)),
      m_pictures(new PictureObjects(this))
{
    setFrameShape(QFrame::NoFrame);
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
    m_folder = folder.scheme() == "qrc" ? ':' + folder.path() : folder.toLocalFile();
    rebuild();
    verticalScrollBar()->setValue(0);
}

void MarkdownView::rebuild()
{
    m_rebuilding = true;
    const int scrolled = verticalScrollBar()->value();
    const FormulaText text = findFormulas(m_markdown);
    document()->clear();
    m_pictures->clear();
    m_formulas.clear();
    for (const FormulaSource &source : text.formulas)
        m_formulas.push_back({source, {}});

    const double size = fontSize(font());
    document()->setDefaultFont(font());
    document()->setDocumentMargin(margin * size);
    document()->setIndentWidth(listIndent * size);
    document()->setMarkdown(text.markdown,
                            QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub)
                                | QTextDocument::MarkdownNoHTML);
    setStyles();
    frameCode();
    placeObjects();
    verticalScrollBar()->setValue(scrolled);
    m_rebuilding = false;
}

void MarkdownView::setStyles()
{
    const double size = fontSize(font());
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        const bool code = isCode(block);
        const bool heading = format.headingLevel() > 0;
        const bool inList = block.textList() && block.next().textList();
        format.setNonBreakableLines(false);
        format.setLineHeight(code ? 0 : lineDistance * size, QTextBlockFormat::LineDistanceHeight);
        format.setTopMargin(heading && block.position() > 0 ? headingGap * size : 0);
        format.setBottomMargin(code ? 0 : (inList ? itemGap : paragraphGap) * size);
        format.setLeftMargin(format.leftMargin() > 0 ? listIndent * size : 0);
        format.setRightMargin(0);
        QTextCursor(block).setBlockFormat(format);
    }
    for (QTextCursor &span : spansOf(document())) {
        const int level = span.blockFormat().headingLevel();
        QTextCharFormat format = span.charFormat();
        if (level > 0) {
            const double scale = level == 1 ? 1.25 : level == 2 ? 1.05 : 1.0;
            format.clearProperty(QTextFormat::FontSizeAdjustment);
            format.setFontPointSize(QFontInfo(font()).pointSizeF() * scale);
            format.setFontWeight(QFont::DemiBold);
        } else if (isCode(span.block()) || format.fontFixedPitch()) {
            format = codeFormat(format, size);
        }
        span.setCharFormat(format);
    }
}

/// Puts each run of code lines into a tinted frame.
void MarkdownView::frameCode()
{
    const double size = fontSize(font());
    QColor tint = palette().color(QPalette::Text);
    tint.setAlphaF(codeTint);
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        if (!isCode(block) || document()->frameAt(block.position()) != document()->rootFrame())
            continue;
        QTextCursor lines(block);
        while (isCode(lines.block().next()))
            lines.movePosition(QTextCursor::NextBlock, QTextCursor::KeepAnchor);
        lines.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        QTextFrameFormat frame;
        frame.setBackground(tint);
        frame.setPadding(paragraphGap * size);
        frame.setLeftMargin(block.blockFormat().indent() * document()->indentWidth());
        frame.setBottomMargin(paragraphGap * size);
        lines.insertFrame(frame);
    }
}

void MarkdownView::placeObjects()
{
    static const QRegularExpression mark(QString::fromUtf16(FormulaText::markPattern)
                                         + '|' + QChar(QChar::ObjectReplacementCharacter));
    for (QTextCursor cursor = document()->find(mark, 0); !cursor.isNull();
         cursor = document()->find(mark, cursor)) {
        const QTextCharFormat format = cursor.charFormat();
        if (format.isImageFormat())
            placeFigure(cursor);
        const QString number = mark.match(cursor.selectedText()).captured(1);
        if (number.isEmpty())
            continue;
        Placed &formula = m_formulas.at(number.toUInt());
        formula.around = format;
        if (isCode(cursor.block()) || format.fontFixedPitch()) {
            cursor.insertText(formula.source.markdown);
            continue;
        }
        if (formula.source.display)
            isolate(cursor);
        showFormula(cursor, number.toInt());
    }
}

/// Gives the selected formula a centred block of its own, unless it starts a list item or stands
/// in a table.
void MarkdownView::isolate(QTextCursor &cursor)
{
    const QTextBlock block = cursor.block();
    const int start = cursor.selectionStart() - block.position();
    const int end = cursor.selectionEnd() - block.position();
    const bool first = block.text().left(start).trimmed().isEmpty();
    const bool last = block.text().mid(end).trimmed().isEmpty();
    if (cursor.currentTable() || (first && block.textList()))
        return;
    cursor.removeSelectedText();
    QTextBlockFormat format = block.blockFormat();
    if (const QTextList *list = block.textList()) {
        format.setObjectIndex(-1);
        format.setIndent(list->format().indent());
    }
    if (!last) {
        cursor.insertBlock(format);
        while (document()->characterAt(cursor.position()) == ' ')
            cursor.deleteChar();
        cursor.setPosition(cursor.block().previous().position() + start);
    }
    if (!first) {
        while (document()->characterAt(cursor.position() - 1) == ' ')
            cursor.deletePreviousChar();
        cursor.insertBlock(format);
    }
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
    if (formula && formula->state == Formula::State::Ready) {
        const double ex = QFontMetricsF(textFont).xHeight() * formulaScale;
        const QFont deep = fontWithDescent(textFont, formula->depth * ex);
        format.clearProperty(QTextFormat::FontPointSize);
        format.setProperty(QTextFormat::FontPixelSize, deep.pixelSize());
        format.setVerticalAlignment(QTextCharFormat::AlignBaseline);
        format.setProperty(QTextFormat::ImageAltText, source.tex);
        Picture picture;
        picture.svg = formula->svg;
        picture.size = QSizeF(formula->width, formula->height) * ex;
        picture.below = QFontMetrics(deep).descent() - formula->depth * ex;
        picture.markdown = source.markdown;
        m_pictures->insert(cursor, format, picture);
        return;
    }
    format = codeFormat(format, fontSize(textFont));
    format.setFontItalic(true);
    QString text = source.tex.simplified();
    if (formula)
        format.setToolTip(formula->error);
    if (formula && formula->state == Formula::State::Broken) {
        const bool dark = palette().color(QPalette::Base).lightness() < 128;
        format.setForeground(QColor(dark ? "#ff8a80" : "#b3261e"));
        text += " (" + formula->error + ')';
    }
    cursor.insertText(text, format);
}

void MarkdownView::replaceFormulas(const QString &tex, bool display)
{
    for (QTextCursor &span : spansOf(document())) {
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
    picture.markdown = QString("![%1](%2)").arg(alt, image.name());
    const QString refusal = readPicture(m_folder, image.name(), picture);
    if (!refusal.isEmpty()) {
        format.setFontItalic(true);
        cursor.insertText(QString("[%1: %2]").arg(alt, refusal), format);
        return;
    }
    constexpr int aloneInBlock = 2;  // itself and the end of the block
    if (cursor.block().length() == aloneInBlock && !cursor.currentTable()) {
        QTextBlockFormat block = cursor.blockFormat();
        block.setAlignment(Qt::AlignHCenter);
        cursor.setBlockFormat(block);
    }
    format.setProperty(QTextFormat::ImageAltText, alt);
    format.setToolTip(image.stringProperty(QTextFormat::ImageTitle));
    m_pictures->insert(cursor, format, picture);
}

QMimeData *MarkdownView::createMimeDataFromSelection() const
{
    QString text;
    QTextCursor at(document());
    for (int i = textCursor().selectionStart(); i < textCursor().selectionEnd(); ++i) {
        at.setPosition(i + 1);
        const Picture *picture = m_pictures->find(at.charFormat());
        const QChar character = document()->characterAt(i);
        const bool picked = picture && character == QChar::ObjectReplacementCharacter;
        text += picked ? picture->markdown : QString(character);
    }
    // Ends of lines, paragraphs and frames, as QTextDocument writes them.
    text.replace(QRegularExpression("[\\x{2028}\\x{2029}\\x{FDD0}\\x{FDD1}]"), "\n");
    auto *mime = new QMimeData;
    mime->setText(text);
    return mime;
}

QVariant MarkdownView::loadResource(int, const QUrl &)
{
    return {};
}

void MarkdownView::changeEvent(QEvent *event)
{
    QTextBrowser::changeEvent(event);
    const bool restyles = event->type() == QEvent::FontChange
                          || event->type() == QEvent::PaletteChange;
    if (restyles && !m_rebuilding)
        rebuild();
}

void MarkdownView::followLink(const QUrl &link)
{
    if (link.scheme() == "step")
        emit stepRequested(link.path());
    else if (link.scheme() == "http" || link.scheme() == "https")
        QDesktopServices::openUrl(link);
}

} // namespace cradle
