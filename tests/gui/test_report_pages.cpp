// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/patience.h"
#include "views/report_printer.h"

#include <QProcess>
#include <QTest>

using namespace cradle;

/// How a report falls into pages, whatever its length.
class TestReportPages final : public QObject
{
    Q_OBJECT
private slots:
    void noPageIsEmpty_data();
    void noPageIsEmpty();
};

namespace {

QString paragraphs(int count)
{
    QString html;
    for (int i = 1; i <= count; ++i)
        html += QStringLiteral("<p style=\"margin: 0\">line %1</p>").arg(i);
    return html;
}

/// The words of each page.
QStringList pagesOf(const QByteArray &pdf)
{
    QProcess reader;
    reader.start(QStringLiteral("pdftotext"), {QStringLiteral("-"), QStringLiteral("-")});
    if (!reader.waitForStarted())
        return {};
    reader.write(pdf);
    reader.closeWriteChannel();
    reader.waitForFinished(patience);
    return QString::fromUtf8(reader.readAllStandardOutput())
        .split(QLatin1Char('\f'), Qt::SkipEmptyParts);
}

} // namespace

void TestReportPages::noPageIsEmpty_data()
{
    QTest::addColumn<QString>("end"); // of the section before the break
    QTest::newRow("text") << QString();
    QTest::newRow("table") << QStringLiteral("<table><tr><th>energy</th><td>1 J</td></tr>"
                                             "<tr><th>momentum</th><td>2 N s</td></tr></table>");
}

/// From half a page to a page and a half, so that one length or another just fits.
void TestReportPages::noPageIsEmpty()
{
    QFETCH(QString, end);
    const QString second = QStringLiteral("<h2 style=\"page-break-before: always\">Second</h2>");
    qsizetype most = 0;
    for (int count = 30; count <= 90; ++count) {
        const LabReportPage page{.html = QStringLiteral("<h2>First</h2>") + paragraphs(count) + end
                                         + second + paragraphs(3)};
        const QStringList pages = pagesOf(printedPdf(page, QStringLiteral("A title")));
        most = std::max(most, pages.size());
        QVERIFY2(!pages.isEmpty(), "is pdftotext installed?");
        QVERIFY(pages.last().contains(QStringLiteral("line 3")));
        for (const QString &text : pages)
            QVERIFY2(text.contains(QStringLiteral("line ")), qPrintable(text));
    }
    QVERIFY(most <= 3);
}

QTEST_MAIN(TestReportPages)
#include "test_report_pages.moc"
