// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"
#include "tests/gui/image_difference.h"
#include "tests/gui/scene_fixture.h"
#include "tests/patience.h"
#include "tests/sanitized.h"
#include "tests/test_paths.h"
#include "views/scene/gl_canvas.h"
#include "views/scene/raster_canvas.h"
#include "views/theme.h"

#include <QProcess>
#include <QTest>

#include <memory>

using namespace cradle::scenes;
using namespace cradle;

namespace {

// What the pictures of the two painters may differ by. Shapes differ by shades at their edges only.
// The glyphs of labels are smoothed in two ways, which is gone in pictures of an eighth of the
// size; there glyphs differ by up to 31, and a label that is missing by more than 100.
constexpr double meanOfShapes = 0.05;    ///< of 255
constexpr double visibleOfShapes = 5e-5; ///< part of the pixels
constexpr int greatestOfCoarse = 40;     ///< of 255

enum class Extras { None, Ghosts, Marks };

QString folder(const char *step)
{
    return sourcePath("tasks/labs/lab-4.2/") + QLatin1String(step);
}

/// The run that the circles would have with all velocities a tenth slower.
std::shared_ptr<Recording> slower(const Preset &preset, qint64 steps)
{
    Preset changed = preset;
    for (PresetCircle &circle : changed.circles)
        circle.body.velocity = 0.9 * circle.body.velocity;
    Simulation simulation(changed);
    simulation.goTo(steps);
    return std::make_shared<Recording>(simulation.recording());
}

} // namespace

class TestPainters : public QObject
{
    Q_OBJECT
private slots:
    void cleanup() { applyTheme(ThemeChoice::Light); }
    void stepsOfTheLabLookAlike_data();
    void stepsOfTheLabLookAlike();
    void theyDoAtTwiceTheScale();

private:
    struct Pictures {
        QImage byGl;
        QImage byRaster;
    };
    static Pictures paint(const ScenePicture &picture);
};

void TestPainters::stepsOfTheLabLookAlike_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<bool>("dark");
    QTest::addColumn<Extras>("extras");
    int count = 0;
    for (const char *step : {"L42T5", "L42T11", "L42T12", "L42T14", "L42T16", "L42T17"}) {
        for (const bool dark : {false, true}) {
            if (++count % oneOf(3) != 0)
                continue;
            QTest::addRow("%s %s", step, dark ? "dark" : "light")
                << folder(step) << dark << Extras::None;
        }
    }
    for (const bool dark : {false, true}) {
        if (dark && oneOf(2) != 1)
            continue;
        QTest::addRow("ghosts %s", dark ? "dark" : "light")
            << folder("L42T17") << dark << Extras::Ghosts;
        QTest::addRow("marks %s", dark ? "dark" : "light")
            << folder("L42T12") << dark << Extras::Marks;
    }
}

/// The moment of the first hit: parts of the hit, trails, labels and the inset, and what else is
/// asked for.
void TestPainters::stepsOfTheLabLookAlike()
{
    QFETCH(QString, step);
    QFETCH(bool, dark);
    QFETCH(Extras, extras);
    if (!glSupport().usable)
        QSKIP(qPrintable(QStringLiteral("nothing to compare with: ") + glSupport().reason));
    applyTheme(dark ? ThemeChoice::Dark : ThemeChoice::Light);
    const Result<Preset> preset = readPreset(step + QStringLiteral("/solution-preset.json"));
    QVERIFY(preset);
    Scene scene;
    scene.document.open(*preset);
    scene.simulation.setShadowed(extras == Extras::Ghosts);
    scene.simulation.seekNextHit();
    QVERIFY(!scene.simulation.recording().hits().empty());
    if (extras == Extras::Ghosts)
        scene.view.setGhost(slower(*preset, scene.simulation.current()),
                            QStringLiteral("reference"));
    if (extras == Extras::Marks) {
        SceneOptions options;
        options.centreOfMass = true;
        scene.view.setOptions(options);
        QTest::keyClick(&scene.view, Qt::Key_A, Qt::ControlModifier);
    }
    ScenePicture picture = scene.view.picture();
    picture.focusFrame = false;
    QVERIFY(picture.list.labels.size() >= 2);
    QVERIFY(picture.list.arrows.size() >= 2);
    QVERIFY(picture.list.lines.size() > 30);
    const Pictures whole = paint(picture);
    QCOMPARE(whole.byGl.size(), whole.byRaster.size());
    const double scale = scene.view.devicePixelRatio();
    QCOMPARE(whole.byGl.size(), (picture.camera.viewport() * scale).toSize());
    const pictures::Difference ofAll = pictures::compare(pictures::coarse(whole.byGl, scale),
                                                         pictures::coarse(whole.byRaster, scale));
    QVERIFY2(ofAll.greatest <= greatestOfCoarse, qPrintable(QString::number(ofAll.greatest)));

    picture.list.labels.clear();
    picture.chips.clear();
    picture.inset.reset();
    const Pictures shapes = paint(picture);
    QVERIFY(pictures::colours(shapes.byRaster) > 20); // it is a scene and not just its background
    const pictures::Difference ofShapes = pictures::compare(shapes.byGl, shapes.byRaster);
    const double part =
        ofShapes.visiblePixels / (shapes.byGl.width() * static_cast<double>(shapes.byGl.height()));
    QVERIFY2(ofShapes.mean <= meanOfShapes && part <= visibleOfShapes,
             qPrintable(QStringLiteral("mean %1, visible %2").arg(ofShapes.mean).arg(part)));
    // The measure tells a label that is missing.
    QVERIFY(
        pictures::compare(pictures::coarse(whole.byGl, scale), pictures::coarse(shapes.byGl, scale))
            .greatest
        > 2 * greatestOfCoarse);
}

/// The scale is chosen when a program starts: another one makes the same comparisons.
void TestPainters::theyDoAtTwiceTheScale()
{
    if (!glSupport().usable)
        QSKIP(qPrintable(QStringLiteral("nothing to compare with: ") + glSupport().reason));
    if (qFuzzyCompare(qApp->devicePixelRatio(), 2.0))
        QSKIP("they are compared at this scale");
    QProcess other;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QStringLiteral("2"));
    other.setProcessEnvironment(environment);
    other.setProcessChannelMode(QProcess::MergedChannels);
    other.start(ownProgram());
    QVERIFY(other.waitForFinished(patience));
    const QByteArray said = other.readAll();
    QVERIFY2(other.exitStatus() == QProcess::NormalExit && other.exitCode() == 0,
             said.right(2000).constData());
    // All were compared, and only this one was left out.
    QVERIFY2(said.contains(" 0 failed, 1 skipped"), said.right(200).constData());
}

TestPainters::Pictures TestPainters::paint(const ScenePicture &picture)
{
    const PictureSource source = [&]() -> const ScenePicture & { return picture; };
    const QSize size = picture.camera.viewport().toSize();
    RasterCanvas raster(source);
    raster.resize(size);
    GlCanvas canvas(source, QStringLiteral(":/shaders"));
    canvas.resize(size);
    canvas.show();
    (void)QTest::qWaitForWindowExposed(&canvas, patience);
    return {canvas.grabFramebuffer().convertToFormat(QImage::Format_RGB32),
            raster.grab().toImage().convertToFormat(QImage::Format_RGB32)};
}

QTEST_MAIN(TestPainters)
#include "test_painters.moc"
