// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QImage>
#include <QObject>
#include <QTextCursor>
#include <QTextFormat>
#include <QTextObjectInterface>

#include <memory>
#include <vector>

class QMimeData;
class QPainter;
class QSvgRenderer;
class QWidget;

namespace cradle {

/// A formula or a figure, which stands for one character in the text.
struct Picture {
    QByteArray svg; ///< drawn in `currentColor`; empty if `image` holds
    QImage image;
    QSizeF size;        ///< px, before it is scaled down to the width of the pane
    double above = 0.0; ///< px of empty space over the picture
    double below = 0.0; ///< px of empty space under it
    QString markdown;   ///< what the clipboard gets
    QString beneath; ///< unseen text where the picture is, for who selects or hears a printed page

    /// Text that no line break may part from the picture, with its font and, in px from the top
    /// of the empty space, its baseline. QTextDocument would break beside any object.
    QString before;
    QString after;
    bool fromRight = false; ///< `before` stands at the right, as in Arabic
    QFont font;
    double baseline = 0.0;

    QByteArray drawn; ///< `svg` in the colour of `painter`
    std::shared_ptr<QSvgRenderer> painter;
    QImage fitted; ///< `image` in the pixels it was last drawn in

    [[nodiscard]] double advance(const QString &text) const; ///< px, in `font`
    [[nodiscard]] QSizeF place() const; ///< px, with the empty space and the text beside it
};

/// Sizes and draws the pictures of a text document.
class PictureObjects final : public QObject, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)
public:
    static constexpr int objectType = QTextFormat::UserObject + 1;
    static constexpr int indexProperty = QTextFormat::UserProperty + 1;

    /// \param widget  whose text colour replaces `currentColor`; null if every format has its own
    explicit PictureObjects(QWidget *widget);

    void clear() { m_pictures.clear(); }

    /// Selections of each stretch of text in one format. They keep their place during edits.
    [[nodiscard]] static std::vector<QTextCursor> spansOf(QTextDocument *document);

    /// Finds the file that the `name` of a picture means in `folder`, and reads it.
    /// \return why it may not or cannot be shown, or nothing
    [[nodiscard]] static QString read(const QString &folder, const QString &name, Picture &picture);

    /// Replaces the selection of `cursor` by a picture that stands on the line.
    void insert(QTextCursor &cursor, QTextCharFormat format, const Picture &picture);

    /// The same for one that reaches `depth` px below the baseline.
    ///
    /// QTextDocument lets objects do so only with AlignMiddle: an object then rises above the
    /// baseline by half the x-height of its character format more than it reaches below. So the
    /// format gets a font size for which that nearly holds, and empty space makes up the rest.
    void insertAtDepth(QTextCursor &cursor, QTextCharFormat format, Picture picture, double depth);

    /// The picture of a format, or nullptr if the format is not one of a picture.
    [[nodiscard]] const Picture *find(const QTextFormat &format) const;

    /// The selected text, with each picture as its Markdown.
    [[nodiscard]] QMimeData *copy(QTextCursor selected) const;

    QSizeF intrinsicSize(QTextDocument *document, int position, const QTextFormat &format) override;
    void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *document, int position,
                    const QTextFormat &format) override;

private:
    static size_t index(const QTextFormat &format);
    static void drawBeneath(QPainter &painter, const QRectF &target, const Picture &picture);
    static void drawImage(QPainter &painter, const QRectF &target, Picture &picture);
    static void drawSvg(QPainter &painter, const QRectF &target, Picture &picture,
                        const QColor &colour);

    QWidget *m_widget;
    std::vector<Picture> m_pictures;
};

} // namespace cradle
