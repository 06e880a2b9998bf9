// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/image_difference.h"
#include "tests/gui/scene_fixture.h"
#include "tests/patience.h"
#include "tests/scenes.h"
#include "views/scene/gl_canvas.h"
#include "views/scene/gl_painter.h"
#include "views/scene/raster_canvas.h"
#include "views/scene/raster_painter.h"

#include <QPainter>
#include <QTest>

using namespace cradle::scenes;
using namespace cradle;

namespace {

/// Whether \p image shows something: its pixels are not all the same.
bool showsSomething(const QImage &image)
{
    const QRgb first = image.pixel(0, 0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixel(x, y) != first)
                return true;
        }
    }
    return false;
}

} // namespace

/// The scene looks alike, whichever painter draws it.
class TestScenePainters : public QObject
{
    Q_OBJECT
private slots:
    void paintersLookAlike();
    void shapesLookAlikeToThePixel();
    void brokenShadersFallBackToRaster();
    void rendererCanBeChanged();
};

void TestScenePainters::paintersLookAlike()
{
    Scene scene;
    scene.simulation.seekNextHit(); // lines, dashes, arrows, discs, labels
    scene.view.select(1);           // and a ring
    SceneOptions options;
    options.momenta = false; // its text is compared in test_painters
    scene.view.setOptions(options);
    scene.view.setRenderer(Renderer::OpenGl);
    if (!glSupport().usable) {
        QCOMPARE(scene.view.activeRenderer(), Renderer::Raster);
        QVERIFY(!scene.view.fallbackReason().isEmpty());
        QVERIFY(showsSomething(scene.view.grab().toImage()));
        return;
    }
    auto *gl = scene.view.findChild<GlCanvas *>();
    QVERIFY(gl);
    const QImage byGl = gl->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    QCOMPARE(scene.view.activeRenderer(), Renderer::OpenGl);
    scene.view.setRenderer(Renderer::Raster);
    const QImage byRaster = scene.view.grab().toImage().convertToFormat(QImage::Format_RGB32);
    QCOMPARE(byGl.size(), byRaster.size());
    QVERIFY(showsSomething(byGl));
    const double mean = pictures::compare(byGl, byRaster).mean;
    QVERIFY2(mean < 0.15, qPrintable(QString::number(mean)));
}

void TestScenePainters::shapesLookAlikeToThePixel()
{
    Scene scene;
    scene.simulation.seekNextHit();
    scene.view.select(1);
    ScenePicture picture = scene.view.picture();
    picture.list.labels.clear(); // their glyphs are smoothed in two ways
    picture.inset.reset();
    picture.loupe.reset();
    picture.focusFrame = false;
    QImage byRaster(700, 700, QImage::Format_RGB32);
    {
        QPainter painter(&byRaster);
        paintShapes(painter, picture.list, picture.camera);
    }
    QVERIFY(showsSomething(byRaster));
    if (!glSupport().usable) {
        QVERIFY(!glSupport().reason.isEmpty());
        return;
    }
    GlCanvas canvas([&]() -> const ScenePicture & { return picture; }, QStringLiteral(":/shaders"));
    canvas.resize(700, 700);
    canvas.show();
    QVERIFY(QTest::qWaitForWindowExposed(&canvas, patience));
    const QImage byGl = canvas.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    const pictures::Difference found = pictures::compare(byGl, byRaster);
    QVERIFY2(found.visiblePixels <= 10, qPrintable(QString::number(found.visiblePixels)));
    QVERIFY2(found.mean < 0.03, qPrintable(QString::number(found.mean)));
}

void TestScenePainters::brokenShadersFallBackToRaster()
{
    Scene scene;
    scene.view.setShaderFolder(QStringLiteral(":/no such folder"));
    scene.view.setRenderer(Renderer::OpenGl);
    QTRY_COMPARE(scene.view.activeRenderer(), Renderer::Raster);
    QVERIFY(!scene.view.fallbackReason().isEmpty());
    QCOMPARE(scene.view.renderer(), Renderer::OpenGl);
    QVERIFY(scene.view.findChild<RasterCanvas *>());
    QVERIFY(showsSomething(scene.view.grab().toImage()));
}

void TestScenePainters::rendererCanBeChanged()
{
    Scene scene;
    for (const Renderer renderer : {Renderer::Raster, Renderer::OpenGl, Renderer::Automatic}) {
        scene.view.setRenderer(renderer);
        QCoreApplication::processEvents();
        QVERIFY(scene.view.activeRenderer() != Renderer::Automatic);
        QVERIFY(showsSomething(scene.view.grab().toImage()));
    }
}

QTEST_MAIN(TestScenePainters)
#include "test_scene_painters.moc"
