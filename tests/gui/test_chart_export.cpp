// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "model/world/measurements.h"
#include "tests/gui/chart_reading.h"
#include "tests/gui/chart_scenes.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "views/charts/energy_chart.h"
#include "views/charts/momentum_chart.h"
#include "views/charts/phase_chart.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSvgRenderer>

using namespace cradle;
using namespace cradle::windows;

class TestChartExport final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void tableHasTheRecordedNumbers();
    void tableIsOfTheWindow();
    void phaseTableHasTheRecordedNumbers();
    void statesAreThoseOfTheRecording();
    void totalsAndEventsAreThoseOfTheRecording();
    void pngIsOpened();
    void phasePictureIsOfNowUnseen();
    void svgIsParsed();
    void zoomedSvgStaysInItsPlot();
    void pictureIsCopied();
    void failureIsReported();
    void cellsAreQuoted();

private:
    [[nodiscard]] QString path(const QString &name) const { return m_folder->filePath(name); }
    /// The submenu \p name of Lab → Export, filled as when it is opened.
    QMenu *exportMenu(const QString &name);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
    MomentumChart *m_momentum = nullptr;
};

void TestChartExport::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    m_open->bench.setMode(Mode::Explore);
    m_open->bench.document().open(falling(2));
    m_open->simulation().goTo(200);
    m_momentum = m_open->window.findChild<MomentumChart *>();
    QTRY_VERIFY(m_momentum->plot().showsRun());
}

void TestChartExport::cleanup()
{
    m_open.reset();
    m_folder.reset();
}

QMenu *TestChartExport::exportMenu(const QString &name)
{
    QMenu *lab = m_open->window.menuBar()->actions().front()->menu();
    QMenu *exports = actionNamed(*lab, QStringLiteral("Export"))->menu();
    emit exports->aboutToShow();
    QAction *found = actionNamed(*exports, name);
    if (!found || !found->menu())
        return nullptr;
    emit found->menu()->aboutToShow();
    return found->menu();
}

void TestChartExport::tableHasTheRecordedNumbers()
{
    QMenu *menu = exportMenu(QStringLiteral("Momentum"));
    QVERIFY(menu);
    answerFileDialog(path(QStringLiteral("m.csv")));
    actionNamed(*menu, QStringLiteral("CSV"))->trigger();
    const auto rows = cellsOf(contentOf(path(QStringLiteral("m.csv"))));
    const Recording &recording = m_open->simulation().recording();
    QCOMPARE(rows.size(), 202); // the header, and steps 0 to 200
    QCOMPARE(rows[0].join(u'|'),
             QStringLiteral("time (s)|sum p_x (kg m/s)|1 p_x (kg m/s)|2 p_x (kg m/s)"));
    for (qint64 i = 0; i <= 200; ++i) {
        const QStringList &row = rows[i + 1];
        const auto circles = recording.circles(i);
        QCOMPARE(row[0].toDouble(), recording.time(i));
        QCOMPARE(row[1].toDouble(), measure(circles, {}, 4.0).momentum.x);
        QCOMPARE(row[2].toDouble(), measure(circles[0], {}, 4.0).momentum.x);
        QCOMPARE(row[3].toDouble(), measure(circles[1], {}, 4.0).momentum.x);
    }
}

void TestChartExport::tableIsOfTheWindow()
{
    m_open->window.phaseChart().timeWindow().zoomTo({1.0, 2.0}, {0.0, 4.0});
    const auto rows = cellsOf(m_momentum->table());
    QVERIFY(rows[1][0].toDouble() >= 1.0 && rows[1][0].toDouble() < 1.02);
    QVERIFY(rows.last()[0].toDouble() <= 2.0 && rows.last()[0].toDouble() > 1.98);
}

void TestChartExport::phaseTableHasTheRecordedNumbers()
{
    PhaseChart &phase = m_open->window.phaseChart();
    phase.setAxes({Quantity::Total, PhaseVariable::together}, {Quantity::Y, 1});
    const auto rows = cellsOf(phase.table());
    const Recording &recording = m_open->simulation().recording();
    QCOMPARE(rows.size(), 202);
    QCOMPARE(rows[0].join(u'|'), QStringLiteral("t (s)|y 2 (m)|total all (J)"));
    for (qint64 i = 0; i <= 200; ++i) {
        QCOMPARE(rows[i + 1][1].toDouble(), recording.circles(i)[1].position.y);
        QCOMPARE(rows[i + 1][2].toDouble(),
                 measure(recording.circles(i), {0.0, -9.81}, 4.0).total());
    }
}

void TestChartExport::statesAreThoseOfTheRecording()
{
    answerFileDialog(path(QStringLiteral("s.csv")));
    m_open->window.runDesk().exportRun(RunTable::States);
    const QByteArray text = contentOf(path(QStringLiteral("s.csv")));
    QVERIFY(text.startsWith("step,time,circle,x,y,vx,vy\n"));
    const auto rows = cellsOf(text);
    const Recording &recording = m_open->simulation().recording();
    QCOMPARE(rows.size(), 1 + 2 * 201);
    for (qint64 i = 0; i <= 200; ++i) {
        for (int c = 0; c < 2; ++c) {
            const QStringList &row = rows[1 + 2 * i + c];
            const Circle &circle = recording.circles(i)[static_cast<std::size_t>(c)];
            QCOMPARE(row[0].toLongLong(), i);
            QCOMPARE(row[1].toDouble(), recording.time(i));
            QCOMPARE(row[2].toInt(), c + 1);
            QVERIFY(row[3].toDouble() == circle.position.x);
            QVERIFY(row[4].toDouble() == circle.position.y);
            QVERIFY(row[5].toDouble() == circle.velocity.x);
            QVERIFY(row[6].toDouble() == circle.velocity.y);
        }
    }
}

void TestChartExport::totalsAndEventsAreThoseOfTheRecording()
{
    const Recording &recording = m_open->simulation().recording();
    answerFileDialog(path(QStringLiteral("t.csv")));
    m_open->window.runDesk().exportRun(RunTable::Totals);
    const auto totals = cellsOf(contentOf(path(QStringLiteral("t.csv"))));
    QCOMPARE(totals.size(), 202);
    for (qint64 i = 0; i <= 200; ++i) {
        const Totals sum = measure(recording.circles(i), {0.0, -9.81}, 4.0);
        QVERIFY(totals[i + 1][2].toDouble() == sum.momentum.x);
        QVERIFY(totals[i + 1][4].toDouble() == sum.kinetic);
        QVERIFY(totals[i + 1][6].toDouble() == sum.total());
    }
    answerFileDialog(path(QStringLiteral("e.csv")));
    m_open->window.runDesk().exportRun(RunTable::Events);
    const auto events = cellsOf(contentOf(path(QStringLiteral("e.csv"))));
    QVERIFY(!recording.hits().empty());
    QCOMPARE(events.size(), 1 + qsizetype(recording.hits().size()));
    for (std::size_t i = 0; i < recording.hits().size(); ++i) {
        const QStringList &row = events[qsizetype(i) + 1];
        QVERIFY(row[0].toDouble() == recording.hits()[i].time);
        QVERIFY(row[6].toDouble() == recording.hits()[i].impulse);
    }
}

/// Its tab was never opened.
void TestChartExport::phasePictureIsOfNowUnseen()
{
    PhaseChart &phase = m_open->window.phaseChart();
    QVERIFY(!phase.isVisible());
    QMenu *menu = exportMenu(phase.windowTitle());
    QVERIFY(menu);
    QVERIFY(actionNamed(*menu, QStringLiteral("PNG"))->isEnabled());
    QImage image(phase.picture().size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    phase.picture().paint(painter);
    painter.end();
    int coloured = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            coloured += image.pixelColor(x, y).hsvSaturation() > 128 ? 1 : 0;
    }
    QVERIFY2(coloured > 50, qPrintable(QString::number(coloured)));
}

void TestChartExport::pngIsOpened()
{
    QMenu *menu = exportMenu(QStringLiteral("Energy"));
    QVERIFY(menu);
    answerFileDialog(path(QStringLiteral("c.png")));
    actionNamed(*menu, QStringLiteral("PNG"))->trigger();
    const QImage image(path(QStringLiteral("c.png")));
    QVERIFY(!image.isNull());
    QVERIFY(image.width() > 500); // twice as fine as on the screen
    // The curves are in it: many colours that neither ground nor text has.
    int coloured = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            coloured += image.pixelColor(x, y).hsvSaturation() > 128 ? 1 : 0;
    }
    QVERIFY2(coloured > 500, qPrintable(QString::number(coloured)));
}

void TestChartExport::svgIsParsed()
{
    QMenu *menu = exportMenu(QStringLiteral("Momentum"));
    answerFileDialog(path(QStringLiteral("c.svg")));
    actionNamed(*menu, QStringLiteral("SVG"))->trigger();
    QSvgRenderer renderer(path(QStringLiteral("c.svg")));
    QVERIFY(renderer.isValid());
    const QByteArray text = contentOf(path(QStringLiteral("c.svg")));
    QVERIFY(text.contains("<polyline"));
    QVERIFY(!text.contains("<image")); // lines, no pixels
}

/// A drawing has no clip, so the curves themselves must end at the plot.
void TestChartExport::zoomedSvgStaysInItsPlot()
{
    m_open->window.phaseChart().timeWindow().zoomTo({1.0, 1.5}, {0.0, 4.0});
    QVERIFY(
        !savePicture(m_momentum->picture(), path(QStringLiteral("z.svg")), QStringLiteral("svg")));
    const QRectF area = m_momentum->plot().plotArea();
    static const QRegularExpression line(QStringLiteral("<polyline [^>]*points=\"([^\"]*)\""));
    const QString text = QString::fromUtf8(contentOf(path(QStringLiteral("z.svg"))));
    auto lines = line.globalMatch(text);
    int points = 0;
    while (lines.hasNext()) {
        for (const QString &point :
             lines.next().captured(1).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            const double x = point.section(QLatin1Char(','), 0, 0).toDouble();
            QVERIFY2(x >= area.left() - 1.0 && x <= area.right() + 1.0, qPrintable(point));
            ++points;
        }
    }
    QVERIFY(points > 4);
}

void TestChartExport::pictureIsCopied()
{
    QMenu menu;
    m_momentum->fillMenu(menu);
    QGuiApplication::clipboard()->clear();
    actionNamed(menu, QStringLiteral("Copy picture"))->trigger();
    QVERIFY(!QGuiApplication::clipboard()->image().isNull());
}

void TestChartExport::failureIsReported()
{
    const QString nowhere = path(QStringLiteral("no/such/folder/c.png"));
    const auto error = savePicture(m_momentum->picture(), nowhere, QStringLiteral("png"));
    QVERIFY(error);
    QCOMPARE(error->file, nowhere);
    QVERIFY(!error->message.isEmpty());
    emit m_momentum->failed(*error);
    QVERIFY(m_open->says(nowhere));
    QVERIFY(saveRunTable(RunTable::States, m_open->simulation().recording(), falling(2), nowhere));
}

void TestChartExport::cellsAreQuoted()
{
    QCOMPARE(csvCell(QStringLiteral("plain")), QStringLiteral("plain"));
    QCOMPARE(csvCell(QStringLiteral("a,b")), QStringLiteral("\"a,b\""));
    QCOMPARE(csvCell(QStringLiteral("a \"b\"")), QStringLiteral("\"a \"\"b\"\"\""));
}

QTEST_MAIN(TestChartExport)

#include "test_chart_export.moc"
