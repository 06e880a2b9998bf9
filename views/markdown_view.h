// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "views/formula_renderer.h"

#include <QPainter>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCharFormat>
#include <QTextList>
#include <QTextObjectInterface>
#include <QUrl>

#include <memory>
#include <vector>

namespace cradle {

/// A formula or a figure, which stands for one character in the text.
struct Picture {
    QByteArray svg; ///< drawn in `currentColor`; empty if `image` holds
    QImage image;
    QSizeF size;        ///< px, before it is scaled down to the width of the pane
    double below = 0.0; ///< px that its place in the line reaches deeper than the picture
    QString markdown;   ///< what the clipboard gets

    QByteArray drawn; ///< `svg` in the colour of `painter`
    std::shared_ptr<QSvgRenderer> painter;
    QImage fitted; ///< `image` in the pixels it was last drawn in
};

/// Sizes and draws the pictures of a text document.
class PictureObjects final : public QObject, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)
public:
    static constexpr int objectType = QTextFormat::UserObject + 1;
    static constexpr int indexProperty = QTextFormat::UserProperty + 1;

    /// \param widget  whose text colour replaces `currentColor`
    explicit PictureObjects(QWidget *widget)
        : QObject(widget)
        , m_widget(widget)
    {
    }

    void clear() { m_pictures.clear(); }

    void insert(QTextCursor &cursor, QTextCharFormat format, const Picture &picture)
    {
        format.setObjectType(objectType);
        format.setProperty(indexProperty, int(m_pictures.size()));
        m_pictures.push_back(picture);
        cursor.insertText(QString(QChar::ObjectReplacementCharacter), format);
    }

    /// The picture of a format, or nullptr if the format is not one of a picture.
    [[nodiscard]] const Picture *find(const QTextFormat &format) const
    {
        return format.objectType() == objectType ? &m_pictures.at(index(format)) : nullptr;
    }

    QSizeF intrinsicSize(QTextDocument *document, int position, const QTextFormat &format) override
    {
        const Picture &picture = m_pictures.at(index(format));
        const QSizeF size = picture.size + QSizeF(0, picture.below);
        const QTextBlock block = document->findBlock(position);
        const int indent = block.blockFormat().indent()
                           + (block.textList() ? block.textList()->format().indent() : 0);
        const double room = document->textWidth() - 2 * document->documentMargin()
                            - indent * document->indentWidth() - block.blockFormat().leftMargin();
        return room > 0 && size.width() > room ? size * (room / size.width()) : size;
    }

    void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *, int,
                    const QTextFormat &format) override
    {
        Picture &picture = m_pictures.at(index(format));
        const double scale = rect.width() / picture.size.width();
        const QRectF target = rect.adjusted(0, 0, 0, -picture.below * scale);
        painter->save();
        painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        if (picture.svg.isEmpty()) {
            const QSize pixels = (target.size() * painter->device()->devicePixelRatioF()).toSize();
            if (picture.fitted.size() != pixels)
                picture.fitted =
                    picture.image.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
            painter->drawImage(target, picture.fitted);
        } else {
            const QColor colour = format.hasProperty(QTextFormat::ForegroundBrush)
                                      ? format.foreground().color()
                                      : m_widget->palette().color(QPalette::Text);
            QByteArray svg = picture.svg;
            svg.replace("currentColor", colour.name().toLatin1());
            if (picture.drawn != svg) {
                picture.painter = std::make_shared<QSvgRenderer>(svg);
                picture.drawn = svg;
            }
            picture.painter->render(painter, target);
        }
        painter->restore();
    }

private:
    static size_t index(const QTextFormat &format)
    {
        return size_t(format.intProperty(indexProperty));
    }

    QWidget *m_widget;
    std::vector<Picture> m_pictures;
};

/// Shows instructions: CommonMark with GitHub's tables, TeX formulas and pictures.
///
/// Raw HTML shows as text. Pictures come from one folder and nothing else is ever loaded. Links
/// to http and https open in the web browser after a click; others do nothing but `step:ID`.
class MarkdownView final : public QTextBrowser
{
    Q_OBJECT
public:
    /// \param renderer  shared with other views and outliving this one; nullptr: one of its own
    explicit MarkdownView(QWidget *parent = nullptr, FormulaRenderer *renderer = nullptr);

    /// \param folder  where pictures may come from: a local folder, or a Qt resource as
    ///     `qrc:/labs/…` or QUrl::fromLocalFile(":/labs/…")
    void setMarkdown(const QString &text, const QUrl &folder);

signals:
    void stepRequested(const QString &id); ///< the student followed a link `step:ID`

protected:
    void changeEvent(QEvent *event) override;
    QMimeData *createMimeDataFromSelection() const override;
    QVariant loadResource(int type, const QUrl &name) override;

private:
    struct Placed {
        FormulaSource source;
        QTextCharFormat around; ///< format of the text that it stands in
    };

    void rebuild();
    void setStyles();
    void frameCode();
    void placeObjects();
    void isolate(QTextCursor &cursor);
    void placeFigure(QTextCursor &cursor);
    void showFormula(QTextCursor &cursor, int index);
    void replaceFormulas(const QString &tex, bool display);
    void followLink(const QUrl &link);

    FormulaRenderer *m_renderer;
    PictureObjects *m_pictures; ///< child
    QString m_markdown;
    QString m_folder;
    std::vector<Placed> m_formulas;
    bool m_rebuilding = false;
};

} // namespace cradle
