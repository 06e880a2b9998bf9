// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/open_window.h"

#include <QPushButton>
#include <QTabBar>

using namespace cradle;
using namespace cradle::windows;

namespace {

/// What of \p widget is seen in the window, px.
QRect seenPart(const QWidget &widget)
{
    QRect rect = widget.rect();
    for (const QWidget *w = &widget; !w->isWindow(); w = w->parentWidget())
        rect = rect.translated(w->pos()).intersected(w->parentWidget()->rect());
    return rect;
}

/// In a pane that scrolls a text may be out of sight.
bool isScrolled(const QWidget &widget)
{
    for (const QWidget *w = &widget; w; w = w->parentWidget()) {
        if (w->inherits("QAbstractScrollArea"))
            return true;
    }
    return false;
}

QString nameOf(const QWidget &widget)
{
    return QStringLiteral("%1 “%2”").arg(QLatin1String(widget.metaObject()->className()),
                                         widget.property("text").toString());
}

} // namespace

/// Texts at 150 and 200 %: nothing is lost.
class TestLargeTexts final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        applyTheme(ThemeChoice::Light);
        QVERIFY(m_folder.isValid());
    }
    void cleanup() { setTextScale(1.0); }
    void nothingIsLost_data();
    void nothingIsLost();

private:
    QTemporaryDir m_folder;
};

void TestLargeTexts::nothingIsLost_data()
{
    QTest::addColumn<int>("percent");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<Mode>("mode");
    QTest::addColumn<QString>("language");
    for (const char *language : {"en", "de"}) {
        for (const int percent : {100, 150, 200}) {
            for (const QSize size : {QSize(1440, 900), QSize(1920, 1080)}) {
                for (const Mode mode : {Mode::Explore, Mode::Code})
                    QTest::addRow("%s %d %% %d %s", language, percent, size.width(),
                                  mode == Mode::Code ? "code" : "explore")
                        << percent << size << mode << QString::fromLatin1(language);
            }
        }
    }
}

void TestLargeTexts::nothingIsLost()
{
    QFETCH(int, percent);
    QFETCH(QSize, size);
    QFETCH(Mode, mode);
    QFETCH(QString, language);
    setLanguage(language);
    setTextScale(percent / 100.0);
    OpenWindow open(m_folder);
    open.bench.openTask(QStringLiteral("L42T11"));
    open.bench.setMode(mode);
    open.window.resize(size);
    QTest::qWait(50);
    open.window.resetLayout();
    QTest::qWait(100);
    QCOMPARE(open.window.size(), size); // no larger than the screen that it is for
    QStringList lost;
    QWidget *check = nullptr;
    std::vector<QWidget *> texts;
    for (auto *each : open.window.findChildren<QWidget *>()) {
        const bool isText = qobject_cast<QLabel *>(each) || qobject_cast<QAbstractButton *>(each);
        if (!isText || !each->isVisible() || each->property("text").toString().isEmpty()
            || each->window() != &open.window)
            continue;
        const QRect seen = seenPart(*each);
        if (auto *button = qobject_cast<QAbstractButton *>(each);
            button && button->text() == open.window.transportBar().checkAction()->text())
            check = each;
        if (isScrolled(*each) || each->visibleRegion().isEmpty())
            continue;
        if (seen.size() != each->size())
            lost << nameOf(*each) + QStringLiteral(" is cut off");
        const auto *button = qobject_cast<QPushButton *>(each);
        if (button && button->width() + 1 < button->minimumSizeHint().width())
            lost << nameOf(*each) + QStringLiteral(" is too narrow");
        texts.push_back(each);
    }
    for (const auto *tabs : open.window.findChildren<QTabBar *>()) {
        if (!tabs->isVisible())
            continue;
        if (tabs->elideMode() != Qt::ElideNone || !tabs->usesScrollButtons())
            lost << QStringLiteral("titles of tabs are cut: ") + tabs->tabText(0);
        for (int i = 0; i < tabs->count(); ++i) {
            if (tabs->tabRect(i).width() < tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)))
                lost << QStringLiteral("no room for the title ") + tabs->tabText(i);
        }
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
        for (std::size_t k = i + 1; k < texts.size(); ++k) {
            if (texts[i]->isAncestorOf(texts[k]) || texts[k]->isAncestorOf(texts[i]))
                continue;
            const QRect both = seenPart(*texts[i]).intersected(seenPart(*texts[k]));
            if (both.width() > 1 && both.height() > 1)
                lost << nameOf(*texts[i]) + QStringLiteral(" lies over ") + nameOf(*texts[k]);
        }
    }
    QVERIFY2(lost.isEmpty(), qPrintable(lost.join(QLatin1Char('\n'))));
    const auto *action = open.window.transportBar().checkAction();
    if (!check) // without its text it has its name
        check = open.button(action->text());
    QVERIFY(check);
    QVERIFY(seenPart(*check).size() == check->size());
    setLanguage(QStringLiteral("en"));
}

QTEST_MAIN(TestLargeTexts)

#include "test_large_texts.moc"
