// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/drawn_texts.h"
#include "tests/gui/room_states.h"
#include "views/code/lua_area.h"

#include <QAbstractScrollArea>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QTreeWidget>

using namespace cradle;
using namespace cradle::windows;

namespace {

constexpr double hair = 1.5;          ///< px that boxes may overlap or be clipped: they are whole
constexpr double leastContrast = 4.5; ///< WCAG 2.1, 1.4.3
constexpr double rounding = 0.05;     ///< of a contrast: colours are kept in bytes

QString describe(const DrawnText &text)
{
    QStringList path;
    for (const QWidget *w = text.widget; w && !w->isWindow() && path.size() < 3;
         w = w->parentWidget())
        path.prepend(QLatin1String(w->metaObject()->className()));
    const auto box = [](const QRectF &rect) {
        return QStringLiteral("%1,%2 %3x%4")
            .arg(rect.x(), 0, 'f', 1)
            .arg(rect.y(), 0, 'f', 1)
            .arg(rect.width(), 0, 'f', 1)
            .arg(rect.height(), 0, 'f', 1);
    };
    return QStringLiteral("“%1” in %2 at %3 (seen %4)")
        .arg(text.text, path.join(QLatin1Char('/')), box(text.ink), box(text.seen));
}

/// What is cut there is reached by scrolling.
bool isReached(const DrawnText &text)
{
    if (qobject_cast<const LuaArea *>(text.widget->parentWidget()))
        return true; // it knows a little later how far
    const bool isTooWide =
        text.seen.left() > text.ink.left() + hair || text.seen.right() < text.ink.right() - hair;
    for (const QWidget *w = text.widget; w; w = w->parentWidget()) {
        if (const auto *area = qobject_cast<const QAbstractScrollArea *>(w)) {
            const QScrollBar *bar =
                isTooWide ? area->horizontalScrollBar() : area->verticalScrollBar();
            if (bar->maximum() > bar->minimum())
                return true;
        }
        const auto *tabs = qobject_cast<const QTabBar *>(w);
        if (tabs && tabs->usesScrollButtons() && isTooWide)
            return true;
    }
    return false;
}

bool isCut(const DrawnText &text)
{
    return text.seen.width() < text.ink.width() - hair
           || text.seen.height() < text.ink.height() - hair;
}

/// The colour that most of \p rect has.
QColor groundOf(const QImage &image, const QRectF &rect)
{
    QHash<QRgb, int> counts;
    QRgb most = 0;
    const QRect area = rect.toAlignedRect().adjusted(-2, -2, 2, 2) & image.rect();
    for (int y = area.top(); y <= area.bottom(); ++y) {
        for (int x = area.left(); x <= area.right(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            if (++counts[pixel] > counts.value(most))
                most = pixel;
        }
    }
    return QColor(most);
}

QColor over(const QColor &ground, const QColor &ink)
{
    const auto part = [&ink](int below, int above) {
        return below + (above - below) * ink.alpha() / 255;
    };
    return {part(ground.red(), ink.red()), part(ground.green(), ink.green()),
            part(ground.blue(), ink.blue())};
}

} // namespace

/// Whatever the window says in whatever state can be read: it is whole, and stands alone on a
/// ground that it can be told from.
class TestLegibleTexts final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_room = std::make_unique<StatefulRoom>(m_folder);
    }
    void cleanupTestCase() { m_room.reset(); }
    void everyTextCanBeRead_data() { addRoomStates(); }
    void everyTextCanBeRead();

private:
    static void findCut(const std::vector<DrawnText> &texts, QStringList &found);
    static void findTouching(const std::vector<DrawnText> &texts, QStringList &found);
    static void findPale(const std::vector<DrawnText> &texts, const QImage &image,
                         QStringList &found);

    QTemporaryDir m_folder;
    std::unique_ptr<StatefulRoom> m_room;
};

void TestLegibleTexts::findCut(const std::vector<DrawnText> &texts, QStringList &found)
{
    for (const DrawnText &each : texts) {
        if (isCut(each) && !isReached(each))
            found << describe(each) + QStringLiteral(" is cut off");
        // A line of a program is told whole when it is pointed at.
        if (each.text.endsWith(QChar(0x2026))
            && !qobject_cast<const QTreeWidget *>(each.widget->parentWidget()))
            found << describe(each) + QStringLiteral(" may be abbreviated");
    }
}

void TestLegibleTexts::findTouching(const std::vector<DrawnText> &texts, QStringList &found)
{
    for (std::size_t i = 0; i < texts.size(); ++i) {
        for (std::size_t k = i + 1; k < texts.size(); ++k) {
            const QRectF both = texts[i].seen & texts[k].seen;
            // The parts of a line follow one upon the other.
            const bool isOneLine = texts[i].widget == texts[k].widget;
            if (both.width() > (isOneLine ? 3.0 * hair : hair) && both.height() > hair)
                found << describe(texts[i]) + QStringLiteral(" touches ") + describe(texts[k]);
        }
    }
}

void TestLegibleTexts::findPale(const std::vector<DrawnText> &texts, const QImage &image,
                                QStringList &found)
{
    const QColor disabled = paletteOf(theme()).color(QPalette::Disabled, QPalette::Text);
    for (const DrawnText &each : texts) {
        if (!each.widget->isEnabled() || each.colour == disabled)
            continue; // as WCAG has it
        const QColor ground = groundOf(image, each.seen);
        const QColor ink = over(ground, each.colour);
        const double ratio = contrast(ink, ground);
        if (ratio < leastContrast - rounding)
            found << QStringLiteral("%1: %2 on %3 is %4 : 1")
                         .arg(describe(each), ink.name(), ground.name())
                         .arg(ratio, 0, 'f', 2);
    }
}

void TestLegibleTexts::everyTextCanBeRead()
{
    QFETCH(RoomState, state);
    m_room->take(state);
    QStringList found;
    for (int turn = 0; turn < StatefulRoom::turns; ++turn) {
        m_room->showBehind(turn);
        const QImage image = m_room->window().grab().toImage();
        const std::vector<DrawnText> texts = drawnTexts(m_room->window());
        QVERIFY2(texts.size() > 60, qPrintable(QString::number(texts.size())));
        findCut(texts, found);
        findTouching(texts, found);
        findPale(texts, image.convertToFormat(QImage::Format_RGB32), found);
    }
    found.removeDuplicates();
    const auto *check =
        m_room->open().button(m_room->window().transportBar().checkAction()->text());
    QVERIFY(check && check->visibleRegion().boundingRect() == check->rect());
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestLegibleTexts)

#include "test_legible_texts.moc"
