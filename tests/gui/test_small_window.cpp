// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/calm.h"
#include "tests/gui/open_window.h"
#include "views/sentence_label.h"
#include "views/values/values_table.h"

#include <QHeaderView>
#include <QScrollBar>

using namespace cradle;
using namespace cradle::windows;

namespace {

bool isWhole(const QTableView &table)
{
    const int rows = table.model()->rowCount();
    const int bottom = table.rowViewportPosition(rows - 1) + table.rowHeight(rows - 1);
    return rows > 0 && bottom <= table.viewport()->height();
}

/// Whether no ancestor cuts \p widget off.
bool isWhollySeen(const QWidget &widget)
{
    QRect rect = widget.rect();
    for (const QWidget *w = &widget; w->parentWidget() && !w->isWindow(); w = w->parentWidget()) {
        rect.translate(w->pos());
        if (!w->parentWidget()->rect().contains(rect))
            return false;
    }
    return widget.isVisible();
}

} // namespace

/// The window at 1280 x 720 px: nothing of two circles is cut.
class TestSmallWindow final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanup();
    void valuesAndSentencesAreWhole_data();
    void valuesAndSentencesAreWhole();
    void circlesAreWhole_data() { addLanguagesAndModes(); }
    void circlesAreWhole();
    void chartsGetWhatTheValuesDoNotNeed();
    void heightsOfTheStudentStay();

private:
    static void addLanguagesAndModes();
    void open(const QString &language, Mode mode, const QString &step);

    QTemporaryDir m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestSmallWindow::initTestCase()
{
    QVERIFY(m_folder.isValid());
}

void TestSmallWindow::cleanup()
{
    m_open.reset();
    setLanguage(QStringLiteral("en"));
}

void TestSmallWindow::addLanguagesAndModes()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<Mode>("mode");
    for (const char *language : {"en", "de", "fr", "ar"}) {
        QTest::addRow("%s explore", language) << QString::fromLatin1(language) << Mode::Explore;
        QTest::addRow("%s code", language) << QString::fromLatin1(language) << Mode::Code;
    }
}

void TestSmallWindow::open(const QString &language, Mode mode, const QString &step)
{
    setLanguage(language);
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.setMode(mode);
    m_open->bench.openTask(step);
    m_open->window.resize(1280, 720);
    calm(m_open->window);
    m_open->window.room().resetLayout(); // as if it had been opened so
    calm(m_open->window);
    QCOMPARE(m_open->window.size(), QSize(1280, 720));
}

void TestSmallWindow::valuesAndSentencesAreWhole_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("en") << QStringLiteral("en");
    QTest::newRow("de") << QStringLiteral("de");
}

void TestSmallWindow::valuesAndSentencesAreWhole()
{
    QFETCH(QString, language);
    open(language, Mode::Explore, QStringLiteral("L42T17"));
    Preset preset = m_open->solution();
    preset.circles[0].body.velocity = {1.37, 0.0};
    m_open->bench.document().open(preset);
    m_open->simulation().setShadowed(true);
    m_open->simulation().seekNextHit();
    m_open->simulation().seekNextHit(); // on the floor, which takes the most words
    m_open->window.findChild<QDockWidget *>(QStringLiteral("values"))->raise();
    calm(m_open->window);
    const auto *values = m_open->window.findChild<ValuesPane *>();
    QVERIFY(values);
    QVERIFY(values->hitSentence().contains(QLatin1Char('(')));
    int told = 0;
    for (const auto *sentence : values->findChildren<SentenceLabel *>()) {
        told += sentence->isVisible() ? 1 : 0;
        QVERIFY2(sentence->toolTip().isEmpty(), qPrintable(sentence->text())); // else it is cut
        QVERIFY2(!sentence->isVisible() || isWhollySeen(*sentence), qPrintable(sentence->text()));
    }
    QCOMPARE(told, 2);
    QVERIFY(isWhole(*values->findChild<QTableView *>()));
}

void TestSmallWindow::circlesAreWhole()
{
    QFETCH(QString, language);
    QFETCH(Mode, mode);
    open(language, mode, QStringLiteral("L42T14"));
    m_open->simulation().goTo(20); // the note on the start takes a line
    for (QDockWidget *dock : m_open->window.panes().docks) {
        if (dock->widget() == &m_open->window.inspector())
            dock->raise();
    }
    calm(m_open->window);
    const auto *table = m_open->window.inspector().findChild<QTableView *>();
    QVERIFY(table->isVisible());
    QVERIFY(isWhole(*table));
    QVERIFY(!table->horizontalScrollBar()->isVisible()); // to the last column
    // No text is wider than its cell, and all of the table is in sight.
    for (int row = 0; row < table->model()->rowCount(); ++row) {
        for (int column = 0; column < table->model()->columnCount(); ++column) {
            const QModelIndex index = table->model()->index(row, column);
            const auto given = index.data(Qt::FontRole);
            const QFontMetrics metrics(given.isValid() ? given.value<QFont>() : table->font());
            const QString text = index.data().toString();
            QVERIFY2(metrics.horizontalAdvance(text) + 4 <= table->columnWidth(column),
                     qPrintable(text));
        }
    }
    // Beside the program the pane is lower by its tabs, and may scroll.
    QVERIFY(mode == Mode::Code || isWhollySeen(*table));
}

void TestSmallWindow::chartsGetWhatTheValuesDoNotNeed()
{
    open(QStringLiteral("en"), Mode::Explore, QStringLiteral("L42T17"));
    const auto height = [this](const char *name) {
        return m_open->window.findChild<QDockWidget *>(QLatin1String(name))->height();
    };
    const int chart = height("momentum");
    m_open->window.resize(1920, 1080);
    calm(m_open->window);
    QVERIFY2(height("values") <= 305, qPrintable(QString::number(height("values"))));
    QVERIFY2(height("energy") >= 140, qPrintable(QString::number(height("energy"))));
    m_open->window.resize(1280, 720);
    calm(m_open->window);
    QVERIFY(std::abs(height("momentum") - chart) <= 2);
}

void TestSmallWindow::heightsOfTheStudentStay()
{
    open(QStringLiteral("en"), Mode::Explore, QStringLiteral("L42T17"));
    const auto dock = [this](const char *name) {
        return m_open->window.findChild<QDockWidget *>(QLatin1String(name));
    };
    const QRect above = dock("momentum")->geometry();
    QTest::mouseClick(&m_open->window, Qt::LeftButton, {},
                      {above.center().x(), above.bottom() + 2});
    m_open->window.resizeDocks({dock("momentum"), dock("inspector")}, {180, 320}, Qt::Vertical);
    calm(m_open->window);
    const double part = dock("inspector")->height() / (1.0 * dock("momentum")->height());
    m_open->window.resize(1920, 1080);
    calm(m_open->window);
    const double after = dock("inspector")->height() / (1.0 * dock("momentum")->height());
    QVERIFY2(std::abs(after / part - 1.0) < 0.1, qPrintable(QString::number(after / part)));
}

QTEST_MAIN(TestSmallWindow)

#include "test_small_window.moc"
