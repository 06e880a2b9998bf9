// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/patience.h"
#include "views/formula_renderer.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>

#include <ctime>

using cradle::Formula;
using cradle::FormulaRenderer;
using cradle::patience;

namespace {

/// The answer to one request, or a formula without any state that a test expects.
Formula answerOf(FormulaRenderer &renderer, const QString &tex, bool display = false)
{
    QSignalSpy spy(&renderer, &FormulaRenderer::ready);
    renderer.request(tex, display);
    return spy.wait(patience) ? spy.first().at(2).value<Formula>() : Formula();
}

/// Number of pixels that a picture marks.
int inkOf(const QByteArray &svg)
{
    QImage image(200, 200, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    QSvgRenderer(QByteArray(svg).replace("currentColor", "#000000")).render(&painter);
    int ink = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            ink += qAlpha(image.pixel(x, y)) > 0 ? 1 : 0;
    }
    return ink;
}

/// CPU time so far, s; unlike wall time it does not depend on what else the machine does.
double cpuSeconds(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

class TestFormulaRenderer : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void typesetsFraction();
    void typesetsTallBracketsWithoutNestedPictures();
    void givesDepthBelowBaseline();
    void tellsWhyTexIsBroken_data();
    void tellsWhyTexIsBroken();
    void saysSoWithoutMathJax();
    void answersLaterEvenIfKnown();
    void answersOnceForTheSameFormula();
    void readsFormulaOfEarlierRunFromDisk();
    void drawsAgainIfCacheFileIsDamaged();
    void survivesDestructionDuringWork();
    void leavesTheThreadOfTheWindowFree();
    void letsMathJaxGoWhileNoFormulaIsAskedFor();

private:
    QTemporaryDir m_folder;
    bool m_hasMathJax = false;
};

void TestFormulaRenderer::initTestCase()
{
    FormulaRenderer renderer(nullptr, m_folder.path()); // links the resource, too
    m_hasMathJax = QFile::exists(QStringLiteral(":/mathjax/mathjax.js"));
}

void TestFormulaRenderer::typesetsFraction()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    FormulaRenderer renderer(nullptr, m_folder.path());
    const Formula formula = answerOf(renderer, QStringLiteral("\\frac{1}{2}"));
    QCOMPARE(formula.state, Formula::State::Ready);
    QVERIFY(formula.width > 0.5 && formula.height > formula.width);
    QVERIFY(inkOf(formula.svg) > 100);
}

void TestFormulaRenderer::typesetsTallBracketsWithoutNestedPictures()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    FormulaRenderer renderer(nullptr, m_folder.path());
    const QString tex =
        QStringLiteral("\\begin{pmatrix} 1 \\\\ 2 \\\\ 3 \\\\ 4 \\\\ 5 \\end{pmatrix}");
    const Formula formula = answerOf(renderer, tex, true);
    QCOMPARE(formula.state, Formula::State::Ready);
    QCOMPARE(formula.svg.count("<svg"), 1); // QtSvg cannot draw an <svg> within another
}

void TestFormulaRenderer::givesDepthBelowBaseline()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    FormulaRenderer renderer(nullptr, m_folder.path());
    const Formula x = answerOf(renderer, QStringLiteral("x"));
    QVERIFY(qAbs(x.height - 1.0) < 0.1); // by the definition of ex
    QVERIFY(x.depth < 0.1);
    QVERIFY(answerOf(renderer, QStringLiteral("p_x")).depth > 0.3);
}

void TestFormulaRenderer::tellsWhyTexIsBroken_data()
{
    QTest::addColumn<QString>("tex");
    QTest::addColumn<QString>("reason");
    QTest::newRow("open brace") << "\\frac{1}{"
                                << "Missing close brace";
    QTest::newRow("unknown name") << "\\circel"
                                  << "\\circel";
    QTest::newRow("nothing") << " "
                             << "empty";
    QTest::newRow("numbered") << "x \\tag{1}"
                              << "\\tag";
}

void TestFormulaRenderer::tellsWhyTexIsBroken()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    QFETCH(QString, tex);
    QFETCH(QString, reason);
    FormulaRenderer renderer(nullptr, m_folder.path());
    const Formula formula = answerOf(renderer, tex, true);
    QCOMPARE(formula.state, Formula::State::Broken);
    QVERIFY2(formula.error.contains(reason), qPrintable(formula.error));
}

void TestFormulaRenderer::saysSoWithoutMathJax()
{
    if (m_hasMathJax)
        QSKIP("built with MathJax");
    FormulaRenderer renderer(nullptr, m_folder.path());
    const Formula formula = answerOf(renderer, QStringLiteral("x"));
    QCOMPARE(formula.state, Formula::State::Unavailable);
    QVERIFY(formula.error.contains(QLatin1String("MathJax")));
}

void TestFormulaRenderer::answersLaterEvenIfKnown()
{
    FormulaRenderer renderer(nullptr, m_folder.path());
    QVERIFY(!renderer.known(QStringLiteral("x"), false));
    const Formula first = answerOf(renderer, QStringLiteral("x"));
    QVERIFY(renderer.known(QStringLiteral("x"), false));
    QVERIFY(!renderer.known(QStringLiteral("x"), true));

    QSignalSpy spy(&renderer, &FormulaRenderer::ready);
    renderer.request(QStringLiteral("x"), false);
    QCOMPARE(spy.count(), 0);
    QVERIFY(spy.wait(patience));
    QCOMPARE(spy.first().at(2).value<Formula>(), first);
}

void TestFormulaRenderer::answersOnceForTheSameFormula()
{
    FormulaRenderer renderer(nullptr, m_folder.path());
    QSignalSpy spy(&renderer, &FormulaRenderer::ready);
    renderer.request(QStringLiteral("a"), false);
    renderer.request(QStringLiteral("a"), false);
    renderer.request(QStringLiteral("b"), false); // answered after all of a
    QTRY_COMPARE(spy.count(), 2);
    QCOMPARE(spy.at(0).at(0).toString(), QStringLiteral("a"));
    QCOMPARE(spy.at(1).at(0).toString(), QStringLiteral("b"));
}

void TestFormulaRenderer::readsFormulaOfEarlierRunFromDisk()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    const QTemporaryDir folder;
    {
        FormulaRenderer renderer(nullptr, folder.path());
        QCOMPARE(answerOf(renderer, QStringLiteral("x")).state, Formula::State::Ready);
    }
    // A mark in the file tells what was read from what was typeset anew.
    const QStringList files = QDir(folder.path()).entryList(QDir::Files);
    QCOMPARE(files.size(), 1);
    QFile file(folder.filePath(files.first()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"svg":"<svg/>","width_ex":7,"height_ex":2,"depth_ex":1})");
    file.close();
    FormulaRenderer renderer(nullptr, folder.path());
    QCOMPARE(answerOf(renderer, QStringLiteral("x")).width, 7.0);
}

void TestFormulaRenderer::drawsAgainIfCacheFileIsDamaged()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    const QTemporaryDir folder;
    Formula whole;
    {
        FormulaRenderer renderer(nullptr, folder.path());
        whole = answerOf(renderer, QStringLiteral("x"));
    }
    const QStringList files = QDir(folder.path()).entryList(QDir::Files);
    QCOMPARE(files.size(), 1);
    QVERIFY(QFile::resize(folder.filePath(files.first()), 20));
    FormulaRenderer renderer(nullptr, folder.path());
    QCOMPARE(answerOf(renderer, QStringLiteral("x")), whole);
}

void TestFormulaRenderer::survivesDestructionDuringWork()
{
    const QTemporaryDir folder;
    for (const int wait : {0, 50, 400}) { // ms: before, while and after MathJax loads
        FormulaRenderer renderer(nullptr, folder.path());
        for (int i = 0; i < 200; ++i)
            renderer.request(QStringLiteral("\\sqrt{\\frac{x_{%1}}{%2}}").arg(i).arg(wait), true);
        QTest::qWait(wait);
    }
}

/// MathJax is loaded and run while the window goes on: nearly all the time is spent elsewhere.
void TestFormulaRenderer::leavesTheThreadOfTheWindowFree()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    const QTemporaryDir folder;
    FormulaRenderer renderer(nullptr, folder.path());
    const double allBefore = cpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
    const double hereBefore = cpuSeconds(CLOCK_THREAD_CPUTIME_ID);
    QCOMPARE(answerOf(renderer, QStringLiteral("\\frac{m_1 - m_2}{m_1 + m_2}")).state,
             Formula::State::Ready);
    const double all = cpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - allBefore;
    const double here = cpuSeconds(CLOCK_THREAD_CPUTIME_ID) - hereBefore;
    QVERIFY2(here < 0.1 * all, qPrintable(QStringLiteral("%1 of %2 s").arg(here).arg(all)));
}

void TestFormulaRenderer::letsMathJaxGoWhileNoFormulaIsAskedFor()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    FormulaRenderer renderer(nullptr, m_folder.path());
    QVERIFY(!renderer.isLoaded());
    QCOMPARE(answerOf(renderer, QStringLiteral("a^{17}")).state, Formula::State::Ready);
    QVERIFY(renderer.isLoaded());
    QTRY_VERIFY(!renderer.isLoaded());
    // What is known needs none; what is new brings it back.
    QCOMPARE(answerOf(renderer, QStringLiteral("a^{17}")).state, Formula::State::Ready);
    QVERIFY(!renderer.isLoaded());
    const Formula later = answerOf(renderer, QStringLiteral("a^{18}"));
    QCOMPARE(later.state, Formula::State::Ready);
    QVERIFY(renderer.isLoaded() && inkOf(later.svg) > 0);
}

QTEST_MAIN(TestFormulaRenderer)
#include "test_formula_renderer.moc"
