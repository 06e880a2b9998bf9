// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/chart_scenes.h"
#include "views/scene/disc_stamps.h"
#include "views/scene/raster_painter.h"
#include "views/timeline.h"

#include <QImage>
#include <QPainter>
#include <QTest>

using namespace cradle;

namespace {

/// Small discs at places that are whole pixels nowhere.
DrawList crowdOf(int count)
{
    DrawList list;
    list.background = Qt::white;
    for (int i = 0; i < count; ++i) {
        const Vec2 centre{-3.9 + 0.317 * (i % 25), -3.9 + 0.331 * (i / 25)};
        list.discs.push_back({centre, 0.1, i % 2 ? Qt::red : Qt::blue, Qt::black, 1.0});
    }
    return list;
}

QImage painted(const DrawList &list, double dpr)
{
    QImage image(QSize(400, 400) * dpr, QImage::Format_RGB32);
    image.setDevicePixelRatio(dpr);
    Camera camera;
    camera.fit(4.0);
    camera.resize({400.0, 400.0});
    QPainter painter(&image);
    paintShapes(painter, list, camera);
    return image;
}

/// The mean difference of two pictures over all pixels and colours, 0 to 255.
double difference(const QImage &x, const QImage &y)
{
    double sum = 0.0;
    for (int row = 0; row < x.height(); ++row) {
        for (int column = 0; column < x.width(); ++column) {
            const QRgb a = x.pixel(column, row);
            const QRgb b = y.pixel(column, row);
            sum += std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b))
                   + std::abs(qBlue(a) - qBlue(b));
        }
    }
    return sum / 3.0 / x.width() / x.height();
}

} // namespace

class TestCrowdedViews final : public QObject
{
    Q_OBJECT
private slots:
    void stampsLookLikeDiscs_data();
    void stampsLookLikeDiscs();
    void largeDiscsAreNotStamped();
    void timelineTellsEndsWhereHitsCrowd();
};

void TestCrowdedViews::stampsLookLikeDiscs_data()
{
    QTest::addColumn<double>("dpr");
    for (const double dpr : {1.0, 1.5, 2.0})
        QTest::addRow("%g", dpr) << dpr;
}

void TestCrowdedViews::stampsLookLikeDiscs()
{
    QFETCH(double, dpr);
    const auto count = static_cast<int>(DiscStamps::crowd);
    const QImage stamped = painted(crowdOf(count), dpr);
    // The same discs, too few at a time to be stamped.
    const DrawList all = crowdOf(count);
    QImage paths = painted({.background = Qt::white}, dpr);
    QPainter painter(&paths);
    painter.setRenderHint(QPainter::Antialiasing);
    Camera camera;
    camera.fit(4.0);
    camera.resize({400.0, 400.0});
    for (const DrawList::Disc &disc : all.discs)
        paintDisc(painter, disc, camera.toPixels(disc.centre),
                  disc.radius * camera.pixelsPerMetre());
    painter.end();
    const double blank = difference(paths, painted({.background = Qt::white}, dpr));
    const double apart = difference(stamped, paths);
    // An eighth of a pixel aside at most, and only edges show it.
    QVERIFY2(apart < 0.05 * blank, qPrintable(QStringLiteral("%1 of %2").arg(apart).arg(blank)));
}

void TestCrowdedViews::largeDiscsAreNotStamped()
{
    QImage image(100, 100, QImage::Format_RGB32);
    QPainter painter(&image);
    DiscStamps stamps;
    const DrawList::Disc filled{{}, 1.0, Qt::red, Qt::black, 1.0};
    const DrawList::Disc ring{{}, 1.0, {}, Qt::black, 1.0};
    QVERIFY(stamps.stamp(painter, filled, {50.0, 50.0}, 4.0));
    QVERIFY(!stamps.stamp(painter, filled, {50.0, 50.0}, 40.0));
    QVERIFY(!stamps.stamp(painter, ring, {50.0, 50.0}, 4.0));
}

void TestCrowdedViews::timelineTellsEndsWhereHitsCrowd()
{
    Preset preset = glancing();
    preset.circles[0].body.velocity = {500.0, 300.0};
    Simulation simulation(preset);
    Timeline timeline(simulation);
    timeline.resize(300, 56);
    run(simulation, 200);
    QVERIFY(simulation.recording().hits().size() > 300);
    QStringList texts;
    for (const Timeline::Label &label : timeline.labels())
        texts << label.text;
    // The ends, and the hit that is shown if it finds room; no others.
    QVERIFY2(texts.size() <= 3, qPrintable(texts.join(u'|')));
    QVERIFY(texts.contains(QStringLiteral("0 s")));
    QVERIFY(!timeline.grab().isNull());
}

QTEST_MAIN(TestCrowdedViews)

#include "test_crowded_views.moc"
