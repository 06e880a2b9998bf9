// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/patience.h"
#include "views/formula_renderer.h"
#include "views/markdown_view.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>

using cradle::FormulaRenderer;
using cradle::MarkdownView;
using cradle::patience;

namespace {

const QChar object = QChar::ObjectReplacementCharacter;

class Browser : public QObject
{
    Q_OBJECT
public:
    QList<QUrl> opened;
public slots:
    void open(const QUrl &url) { opened += url; }
};

int pixelsLike(const QWidget &widget, const QColor &colour)
{
    const QImage image = const_cast<QWidget &>(widget).grab().toImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y) == colour ? 1 : 0;
    }
    return count;
}

QImage pictureOf(QWidget &widget, double scale)
{
    QImage image(widget.size() * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    widget.render(&image);
    image.setDevicePixelRatio(1.0);
    return image;
}

/// Sum of the squares of the differences between neighbours in a row: a blurred edge has less.
double sharpness(const QImage &image)
{
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 1; x < image.width(); ++x) {
            const double step = qGray(image.pixel(x, y)) - qGray(image.pixel(x - 1, y));
            sum += step * step;
        }
    }
    return sum;
}

void setColours(QWidget &widget, const QColor &text, const QColor &base)
{
    QPalette palette;
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::Base, base);
    widget.setPalette(palette);
}

} // namespace

class TestMarkdownView : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void showsTexUntilFormulaIsReady();
    void drawsFormulaInColourOfText();
    void isSharpAtTwiceTheScale();
    void showsReasonOfBrokenTex();
    void givesDisplayFormulaItsOwnCentredLine();
    void keepsPunctuationWithFormula();
    void leavesCodeAndDollarsAlone_data();
    void leavesCodeAndDollarsAlone();
    void copiesFormulaAsTex();
    void showsFigureInColourOfText();
    void fitsWideFigureIntoPane();
    void showsReasonOfRefusedPicture();
    void ignoresForgedMarks();
    void opensOnlyWebLinksAndSteps();

private:
    /// Shows `markdown` and waits for the answers to its formulas.
    void show(MarkdownView &view, const QByteArray &markdown, int formulas = 0);

    QTemporaryDir m_folder;
    FormulaRenderer m_renderer{nullptr, m_folder.filePath(QStringLiteral("cache"))};
    bool m_hasMathJax = false;
};

void TestMarkdownView::initTestCase()
{
    m_hasMathJax = QFile::exists(QStringLiteral(":/mathjax/mathjax.js"));
    const auto write = [this](const QString &name, const QByteArray &content) {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    };
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("lab/pictures")));
    const QByteArray box = "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='60'>"
                           "<rect width='600' height='60' fill='currentColor'/></svg>";
    write(QStringLiteral("lab/box.svg"), box);
    write(QStringLiteral("lab/pictures/box.svg"), box);
    write(QStringLiteral("outside.svg"), box);
}

void TestMarkdownView::show(MarkdownView &view, const QByteArray &markdown, int formulas)
{
    view.resize(320, 400);
    QSignalSpy spy(&m_renderer, &FormulaRenderer::ready);
    view.setMarkdown(QString::fromUtf8(markdown),
                     QUrl::fromLocalFile(m_folder.filePath(QStringLiteral("lab"))));
    QTRY_COMPARE(spy.count(), formulas);
}

void TestMarkdownView::showsTexUntilFormulaIsReady()
{
    MarkdownView view(nullptr, &m_renderer);
    QSignalSpy spy(&m_renderer, &FormulaRenderer::ready);
    view.setMarkdown(QStringLiteral("Keep $p_1$ here"), {});
    QCOMPARE(view.toPlainText(), QStringLiteral("Keep p_1 here"));
    QVERIFY(spy.wait(patience));
    const QString drawn = QStringLiteral("Keep %1 here").arg(object);
    QCOMPARE(view.document()->toRawText(), m_hasMathJax ? drawn : QStringLiteral("Keep p_1 here"));
}

void TestMarkdownView::drawsFormulaInColourOfText()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    MarkdownView view(nullptr, &m_renderer);
    setColours(view, Qt::red, Qt::white);
    show(view, "$\\rule{2em}{2em} \\frac{a}{b}$", 1);
    QVERIFY(pixelsLike(view, Qt::red) > 5);
    setColours(view, Qt::green, Qt::black);
    QVERIFY(pixelsLike(view, Qt::green) > 5);
    QCOMPARE(pixelsLike(view, Qt::red), 0);
}

void TestMarkdownView::isSharpAtTwiceTheScale()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    MarkdownView view(nullptr, &m_renderer);
    setColours(view, Qt::black, Qt::white);
    show(view, "$$\\frac{m_1 - m_2}{m_1 + m_2}$$", 1);
    view.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const QImage twice = pictureOf(view, 2.0);
    const QImage enlarged =
        pictureOf(view, 1.0).scaled(twice.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    QVERIFY(sharpness(enlarged) > 0.0);
    QVERIFY(sharpness(twice) > 2.0 * sharpness(enlarged));
}

void TestMarkdownView::showsReasonOfBrokenTex()
{
    MarkdownView view(nullptr, &m_renderer);
    show(view, "A $\\frac{1}{$ b", 1);
    const QString reason = m_hasMathJax ? QStringLiteral(" (Missing close brace)") : QString();
    QCOMPARE(view.toPlainText(), QStringLiteral("A \\frac{1}{%1 b").arg(reason));
}

void TestMarkdownView::givesDisplayFormulaItsOwnCentredLine()
{
    MarkdownView view(nullptr, &m_renderer);
    show(view, "So $$c = d$$ holds.\n\n- item $$e = f$$ on\n", 2);
    const QString first = m_hasMathJax ? QString(object) : QStringLiteral("c = d");
    const QString second = m_hasMathJax ? QString(object) : QStringLiteral("e = f");
    const QStringList lines = {QStringLiteral("So"),   first,  QStringLiteral("holds."),
                               QStringLiteral("item"), second, QStringLiteral("on")};
    QCOMPARE(view.document()->toRawText().split(QChar::ParagraphSeparator), lines);
    const QTextBlock block = view.document()->findBlockByNumber(1);
    QCOMPARE(block.blockFormat().alignment(), Qt::AlignHCenter);
    QVERIFY(!view.document()->findBlockByNumber(4).textList());
}

void TestMarkdownView::keepsPunctuationWithFormula()
{
    if (!m_hasMathJax)
        QSKIP("built without MathJax");
    MarkdownView view(nullptr, &m_renderer);
    show(view, "the sum ($q_1$), too", 1);
    QCOMPARE(view.document()->toRawText(), QStringLiteral("the sum %1 too").arg(object));
}

void TestMarkdownView::leavesCodeAndDollarsAlone_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("text");
    QTest::newRow("prices") << "$5 and $6"
                            << "$5 and $6";
    QTest::newRow("escaped") << "\\$x\\$"
                             << "$x$";
    QTest::newRow("code span") << "a `$x$` b"
                               << "a $x$ b";
    QTest::newRow("fenced block") << "```\n$x_1$ = $_y_$\n```"
                                  << "$x_1$ = $_y_$";
    QTest::newRow("indented block") << "a\n\n    $x_1$ = $y_1$\n"
                                    << "a\n$x_1$ = $y_1$";
    QTest::newRow("HTML") << "a <img src=\"x.png\"> b"
                          << "a <img src=\"x.png\"> b";
}

void TestMarkdownView::leavesCodeAndDollarsAlone()
{
    QFETCH(QString, markdown);
    QFETCH(QString, text);
    MarkdownView view(nullptr, &m_renderer);
    show(view, markdown.toUtf8());
    QString shown = view.toPlainText().trimmed();
    // A frame of code brings empty lines.
    shown.replace(QRegularExpression(QStringLiteral("\n+")), QStringLiteral("\n"));
    QCOMPARE(shown, text);
}

void TestMarkdownView::copiesFormulaAsTex()
{
    MarkdownView view(nullptr, &m_renderer);
    show(view, "Sum ($m_1$), and\n\n$$m_2 = 3$$", 2);
    view.selectAll();
    view.copy();
    const QString copied = QGuiApplication::clipboard()->text();
    QCOMPARE(copied, m_hasMathJax ? QStringLiteral("Sum ($m_1$), and\n$$m_2 = 3$$")
                                  : QStringLiteral("Sum (m_1), and\nm_2 = 3"));
}

void TestMarkdownView::showsFigureInColourOfText()
{
    MarkdownView view(nullptr, &m_renderer);
    setColours(view, Qt::red, Qt::white);
    show(view, "![box](pictures/box.svg)");
    QVERIFY(pixelsLike(view, Qt::red) > 1000);
    setColours(view, Qt::green, Qt::black);
    QVERIFY(pixelsLike(view, Qt::green) > 1000);
    QCOMPARE(pixelsLike(view, Qt::red), 0);
}

void TestMarkdownView::fitsWideFigureIntoPane()
{
    MarkdownView view(nullptr, &m_renderer);
    show(view, "![box](box.svg)");
    view.grab(); // lays the text out
    QVERIFY(view.document()->idealWidth() <= view.viewport()->width());
}

void TestMarkdownView::showsReasonOfRefusedPicture()
{
    MarkdownView view(nullptr, &m_renderer);
    show(view, "![two circles](../outside.svg)");
    QVERIFY(!view.document()->toRawText().contains(object));
    QVERIFY(view.toPlainText().contains(QLatin1String("two circles")));
    QVERIFY(view.toPlainText().contains(QLatin1String("in the folder")));
}

void TestMarkdownView::ignoresForgedMarks()
{
    MarkdownView view(nullptr, &m_renderer);
    show(view, "a &#xE000;7&#xE001; b");
    QVERIFY(view.toPlainText().contains(u'7'));
}

void TestMarkdownView::opensOnlyWebLinksAndSteps()
{
    Browser browser;
    const QStringList schemes = {QStringLiteral("http"), QStringLiteral("https"),
                                 QStringLiteral("file"), QStringLiteral("ftp")};
    for (const QString &scheme : schemes)
        QDesktopServices::setUrlHandler(scheme, &browser, "open");
    MarkdownView view(nullptr, &m_renderer);
    QSignalSpy steps(&view, &MarkdownView::stepRequested);
    for (const char *link : {"https://example.org", "file:///etc/passwd", "ftp://example.org",
                             "step:L42T1", "other.md", "javascript:alert(1)"})
        emit view.anchorClicked(QUrl(QLatin1String(link)));
    for (const QString &scheme : schemes)
        QDesktopServices::unsetUrlHandler(scheme);
    QCOMPARE(browser.opened, QList<QUrl>{QUrl(QStringLiteral("https://example.org"))});
    QCOMPARE(QList<QVariantList>(steps), QList<QVariantList>{{QStringLiteral("L42T1")}});
}

QTEST_MAIN(TestMarkdownView)
#include "test_markdown_view.moc"
