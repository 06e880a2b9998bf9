// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/drawn_texts.h"
#include "tests/patience.h"
#include "views/author/rows_list.h"
#include "views/theme.h"

#include <QTest>

using namespace cradle;

/// Rows of the author's lists that take several lines.
class TestRowsList final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void cleanupTestCase() { setTextScale(1.0); }
    void rowsAreAsHighAsTheirLines_data();
    void rowsAreAsHighAsTheirLines();
};

void TestRowsList::rowsAreAsHighAsTheirLines_data()
{
    QTest::addColumn<double>("scale");
    QTest::newRow("100 %") << 1.0;
    QTest::newRow("150 %") << 1.5;
    QTest::newRow("200 %") << 2.0;
}

void TestRowsList::rowsAreAsHighAsTheirLines()
{
    QFETCH(double, scale);
    setTextScale(scale);
    const auto list = std::make_unique<RowsList>(QStringLiteral("rows"), nullptr);
    list->wrapRows();
    list->addItem(QStringLiteral("Momentum and kinetic energy are kept"));
    list->resize(static_cast<int>(400 * scale), 300);
    list->show();
    QVERIFY(QTest::qWaitForWindowExposed(list.get(), patience));
    const int oneLine = list->visualItemRect(list->item(0)).height();
    const int line = list->fontMetrics().lineSpacing();
    for (int width = static_cast<int>(400 * scale); width > 120 * scale; --width) {
        list->resize(width, 300);
        QCoreApplication::processEvents();
        list->doItemsLayout();
        int lines = 0;
        double below = -line; // the line before, px
        bool isWhole = true;
        for (const DrawnText &text : drawnTexts(*list)) {
            lines += text.ink.center().y() > below + 0.6 * line ? 1 : 0;
            below = text.ink.center().y();
            isWhole = isWhole && text.seen.width() > text.ink.width() - 1.0;
        }
        const int height = list->visualItemRect(list->item(0)).height();
        QVERIFY2(isWhole && qAbs(height - oneLine - (lines - 1) * line) <= lines,
                 qPrintable(QStringLiteral("%1 px for %2 lines at a width of %3")
                                .arg(height)
                                .arg(lines)
                                .arg(width)));
    }
}

QTEST_MAIN(TestRowsList)

#include "test_rows_list.moc"
