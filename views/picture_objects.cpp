// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/picture_objects.h"

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QFileInfo>
#include <QFontMetricsF>
#include <QImageReader>
#include <QMimeData>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextList>
#include <QUrl>
#include <QWidget>

#include <algorithm>

namespace cradle {

namespace {

/// Pixels of one side. A picture that is longer would push all text out of sight, if it could be
/// held at all.
constexpr int longestSide = 8192;
constexpr qint64 mostBytes = 32 * 1024 * 1024;

bool isFit(QSizeF size)
{
    return size.width() <= longestSide && size.height() <= longestSide;
}

} // namespace

double Picture::advance(const QString &text) const
{
    return text.isEmpty() ? 0.0 : QFontMetricsF(font).horizontalAdvance(text);
}

QSizeF Picture::place() const
{
    return size + QSizeF(advance(before) + advance(after), above + below);
}

PictureObjects::PictureObjects(QWidget *widget)
    : QObject(widget)
    , m_widget(widget)
{
}

std::vector<QTextCursor> PictureObjects::spansOf(QTextDocument *document)
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

QString PictureObjects::read(const QString &folder, const QString &name, Picture &picture)
{
    static const QRegularExpression elsewhere(QStringLiteral("^([A-Za-z][A-Za-z0-9+.-]*:|//)"));
    static const QRegularExpression reference(
        QStringLiteral("<image\\b[^>]*href\\s*=\\s*[\"'](?!data:)"));
    const QString path = QUrl::fromPercentEncoding(name.toUtf8());
    const QFileInfo file(folder + u'/' + path);
    // A symbolic link may lead out of the folder, too.
    const QString home = QFileInfo(folder).canonicalFilePath() + u'/';
    if (path.contains(elsewhere))
        return tr("pictures from elsewhere are not loaded");
    if (path.startsWith(u'/') || path.startsWith(u':') || path.contains(u'\\')
        || path.split(u'/').contains(QLatin1String(".."))
        || (file.exists() && !file.canonicalFilePath().startsWith(home)))
        return tr("the picture must be in the folder of the instructions");
    QFile content(file.filePath());
    if (folder.isEmpty() || !file.isFile() || !content.open(QIODevice::ReadOnly))
        return tr("there is no picture %1").arg(path);
    if (file.size() > mostBytes)
        return tr("the picture cannot be read");
    if (file.suffix().compare(QLatin1String("svg"), Qt::CaseInsensitive) == 0) {
        picture.svg = content.readAll();
        if (QString::fromUtf8(picture.svg).contains(reference))
            return tr("the picture refers to another file");
        picture.size = QSvgRenderer(picture.svg).defaultSize();
    } else {
        QImageReader reader(&content);
        picture.size = reader.size();
        if (isFit(picture.size))
            picture.size = (picture.image = reader.read()).size();
    }
    if (picture.size.isEmpty())
        return tr("the picture cannot be read");
    return isFit(picture.size)
               ? QString()
               : tr("the picture is too large; at most %1 × %1 pixels are right").arg(longestSide);
}

void PictureObjects::insert(QTextCursor &cursor, QTextCharFormat format, const Picture &picture)
{
    format.setObjectType(objectType);
    format.setProperty(indexProperty, int(m_pictures.size()));
    m_pictures.push_back(picture);
    cursor.insertText(QString(QChar::ObjectReplacementCharacter), format);
}

void PictureObjects::insertAtDepth(QTextCursor &cursor, QTextCharFormat format, Picture picture,
                                   double depth)
{
    const double rise = picture.size.height() - depth;
    QFont fit = picture.font;
    fit.setPixelSize(1);
    while (QFontMetrics(fit).xHeight() < 2 * (rise - depth))
        fit.setPixelSize(fit.pixelSize() + 1);
    const double surplus = rise - depth - QFontMetrics(fit).xHeight() / 2.0;
    picture.above = qMax(0.0, -surplus);
    picture.below = qMax(0.0, surplus);
    picture.baseline = picture.above + rise;
    format.clearProperty(QTextFormat::FontPointSize);
    format.setProperty(QTextFormat::FontPixelSize, fit.pixelSize());
    format.setVerticalAlignment(QTextCharFormat::AlignMiddle);
    insert(cursor, format, picture);
}

const Picture *PictureObjects::find(const QTextFormat &format) const
{
    return format.objectType() == objectType ? &m_pictures.at(index(format)) : nullptr;
}

QMimeData *PictureObjects::copy(QTextCursor selected) const
{
    // Ends of lines, paragraphs and frames, as QTextDocument writes them.
    static const QRegularExpression end(QStringLiteral("[\\x{2028}\\x{2029}\\x{FDD0}\\x{FDD1}]"));
    QString text;
    const int last = selected.selectionEnd();
    for (int i = selected.selectionStart(); i < last; ++i) {
        selected.setPosition(i + 1);
        const QChar character = selected.document()->characterAt(i);
        const Picture *picture = find(selected.charFormat());
        const bool drawn = picture && character == QChar::ObjectReplacementCharacter;
        text += drawn ? picture->markdown : QString(character);
    }
    auto *mime = new QMimeData;
    mime->setText(text.replace(end, QStringLiteral("\n")));
    return mime;
}

QSizeF PictureObjects::intrinsicSize(QTextDocument *document, int position,
                                     const QTextFormat &format)
{
    const QSizeF place = m_pictures.at(index(format)).place();
    const QTextBlock block = document->findBlock(position);
    const int indent =
        block.blockFormat().indent() + (block.textList() ? block.textList()->format().indent() : 0);
    const double room = document->textWidth() - 2 * document->documentMargin()
                        - indent * document->indentWidth() - block.blockFormat().leftMargin();
    return room > 0 && place.width() > room ? place * (room / place.width()) : place;
}

void PictureObjects::drawObject(QPainter *painter, const QRectF &rect, QTextDocument *document,
                                int position, const QTextFormat &format)
{
    Picture &picture = m_pictures.at(index(format));
    const double scale = rect.width() / picture.place().width();
    const QString &left = picture.fromRight ? picture.after : picture.before;
    const QString &right = picture.fromRight ? picture.before : picture.after;
    const QRectF target(QPointF(picture.advance(left), picture.above), picture.size);
    QPointF corner = rect.topLeft();
    if (format.toCharFormat().verticalAlignment() == QTextCharFormat::AlignMiddle) {
        // AlignMiddle makes room as promised, but puts the object halfway up the line.
        const QTextBlock block = document->findBlock(position);
        const QTextLine line = block.layout()->lineForTextPosition(position - block.position());
        corner.setY(document->documentLayout()->blockBoundingRect(block).top() + line.y()
                    + line.ascent() - picture.baseline * scale);
    }
    const QColor colour = format.hasProperty(QTextFormat::ForegroundBrush)
                              ? format.foreground().color()
                              : m_widget->palette().color(QPalette::Text);
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter->translate(corner);
    painter->scale(scale, scale);
    painter->setPen(colour);
    painter->setFont(picture.font);
    painter->setLayoutDirection(picture.fromRight ? Qt::RightToLeft : Qt::LeftToRight);
    painter->drawText(QPointF(0, picture.baseline), left);
    painter->drawText(QPointF(target.right(), picture.baseline), right);
    drawBeneath(*painter, target, picture);
    if (picture.svg.isEmpty())
        drawImage(*painter, target, picture);
    else
        drawSvg(*painter, target, picture, colour);
    painter->restore();
}

size_t PictureObjects::index(const QTextFormat &format)
{
    return size_t(format.intProperty(indexProperty));
}

void PictureObjects::drawBeneath(QPainter &painter, const QRectF &target, const Picture &picture)
{
    const double width = picture.advance(picture.beneath);
    if (width <= 0.0)
        return;
    painter.save();
    painter.translate(target.left(), picture.baseline);
    // Evenly: else the gaps between words would be too narrow for readers to find.
    const double scale = std::min(1.0, target.width() / width);
    painter.scale(scale, scale);
    painter.setPen(QColor(0, 0, 0, 0)); // a PDF keeps text of which nothing shows
    painter.drawText(QPointF(), picture.beneath);
    painter.restore();
}

void PictureObjects::drawImage(QPainter &painter, const QRectF &target, Picture &picture)
{
    const QSize pixels = painter.deviceTransform().mapRect(target).size().toSize();
    if (picture.fitted.size() != pixels)
        picture.fitted =
            picture.image.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    painter.drawImage(target, picture.fitted);
}

void PictureObjects::drawSvg(QPainter &painter, const QRectF &target, Picture &picture,
                             const QColor &colour)
{
    QByteArray svg = picture.svg;
    svg.replace("currentColor", colour.name().toLatin1());
    if (picture.drawn != svg) {
        picture.painter = std::make_shared<QSvgRenderer>(svg);
        picture.drawn = svg;
    }
    picture.painter->render(&painter, target);
}

} // namespace cradle
