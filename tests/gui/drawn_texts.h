// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractScrollArea>
#include <QApplication>
#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainter>
#include <QPointer>
#include <QScrollBar>
#include <QWidget>

#include <cmath>
#include <vector>

namespace cradle {

/// A text, or the part of one that has one font and direction, as it stands in a window.
struct DrawnText {
    QPointer<QWidget> widget; ///< that drew it
    QString text;
    QRectF ink;  ///< the box of its letters in the window, px
    QRectF seen; ///< what of that box is not clipped
    QColor colour;
};

/// Takes down what is written on it; everything else is lost.
class TextRecorder final : public QPaintDevice
{
public:
    explicit TextRecorder(const QWidget &window)
        : m_size(window.size())
        , m_dpi(window.logicalDpiX())
        , m_engine(*this)
    {
    }
    QPaintEngine *paintEngine() const override { return &m_engine; }

    QPointer<QWidget> painted; ///< whose turn it is
    std::vector<DrawnText> texts;

protected:
    int metric(PaintDeviceMetric metric) const override
    {
        switch (metric) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return m_dpi;
        case PdmDepth:
            return 32;
        case PdmNumColors:
            return 1 << 24;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    class Engine final : public QPaintEngine
    {
    public:
        explicit Engine(TextRecorder &recorder)
            : QPaintEngine(AllFeatures)
            , m_recorder(recorder)
        {
        }
        bool begin(QPaintDevice *) override
        {
            setActive(true);
            return true;
        }
        bool end() override
        {
            setActive(false);
            return true;
        }
        Type type() const override { return User; }
        void updateState(const QPaintEngineState &) override {}
        void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override {}
        void drawPath(const QPainterPath &) override {}
        void drawPolygon(const QPointF *, int, PolygonDrawMode) override {}
        void drawPolygon(const QPoint *, int, PolygonDrawMode) override {}
        void drawTextItem(const QPointF &at, const QTextItem &item) override
        {
            const QString text = item.text().trimmed();
            if (text.isEmpty() || painter()->opacity() < 0.1)
                return;
            const QTransform toWindow = painter()->deviceTransform();
            QRectF box = QFontMetricsF(item.font()).tightBoundingRect(item.text());
            if (item.renderFlags() & QTextItem::RightToLeft) { // its end is where it begins
                box.setLeft(0.0);
                box.setWidth(item.width());
            }
            const QRectF ink = toWindow.mapRect(box.translated(at));
            QRectF seen = ink;
            if (!systemClip().isEmpty())
                seen &= QRectF(systemClip().boundingRect());
            if (painter()->hasClipping())
                seen &= toWindow.mapRect(painter()->clipBoundingRect());
            m_recorder.texts.push_back(
                {m_recorder.painted, text, ink, seen, painter()->pen().color()});
        }

    private:
        TextRecorder &m_recorder;
    };

    QSize m_size;
    int m_dpi;
    mutable Engine m_engine;
};

/// Notes whose turn it is to draw.
class PaintWatcher final : public QObject
{
public:
    explicit PaintWatcher(TextRecorder &recorder)
        : m_recorder(recorder)
    {
        qApp->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::Paint)
            m_recorder.painted = qobject_cast<QWidget *>(watched);
        return false;
    }

private:
    TextRecorder &m_recorder;
};

/// All that is written in \p window, whatever draws it.
inline std::vector<DrawnText> drawnTexts(QWidget &window)
{
    TextRecorder recorder(window);
    const PaintWatcher watcher(recorder);
    window.render(&recorder);
    std::erase_if(recorder.texts,
                  [](const DrawnText &each) { return !each.widget || each.seen.isEmpty(); });
    return recorder.texts;
}

} // namespace cradle
