// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/bound_units.h"

#include "tasks/text/formula_text.h"

#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>

using namespace cradle;

class TestBoundUnits : public QObject
{
    Q_OBJECT
private slots:
    void keepsTogetherWhatIsReadInOneGo_data();
    void keepsTogetherWhatIsReadInOneGo();
    void keepsTheFormatOfWhatItBinds();
    void linesNeverBreakBeforeAUnit();
};

namespace {

/// Where a line may not break stands "_", a slash that is bound is "|".
QString bound(const QString &markdown)
{
    QTextDocument document;
    document.setMarkdown(findFormulas(markdown).markdown, QTextDocument::MarkdownNoHTML);
    bindUnits(&document);
    QStringList blocks;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        blocks.append(block.text());
    QString text = blocks.join(QLatin1Char('\n'));
    text.replace(QStringLiteral("\u2060/\u2060"), QStringLiteral("|"));
    return text.replace(QChar(QChar::Nbsp), QLatin1Char('_'));
}

} // namespace

void TestBoundUnits::keepsTogetherWhatIsReadInOneGo_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const QString &markdown, const QString &expected) {
        QTest::newRow(name) << markdown << expected;
    };
    row("length", QStringLiteral("at 3.8 m and 2 m."), QStringLiteral("at 3.8_m and 2_m."));
    row("speed", QStringLiteral("with 2 m/s, 9.81 m/s²"), QStringLiteral("with 2_m|s, 9.81_m|s²"));
    row("momentum", QStringLiteral("522.8 kg m/s"), QStringLiteral("522.8_kg_m|s"));
    row("impulse", QStringLiteral("−1045.5 N s."), QStringLiteral("−1045.5_N_s."));
    row("density", QStringLiteral("in 1000 kg/m³"), QStringLiteral("in 1000_kg|m³"));
    row("vector", QStringLiteral("to (−2, 2.5) m"), QStringLiteral("to (−2,_2.5)_m"));
    row("formula", QStringLiteral("$x = 3$ m"), QStringLiteral("\uE0000\uE001")); // in its picture
    row("unit alone", QStringLiteral("in m/s it"), QStringLiteral("in m|s it"));
    row("percent", QStringLiteral("only 3.9 % of it"), QStringLiteral("only 3.9_% of it"));
    row("words", QStringLiteral("step 1 shows 2 more, 3 months"),
        QStringLiteral("step 1 shows 2 more, 3 months"));
    row("list of words", QStringLiteral("(one, 2) and (3, two)"),
        QStringLiteral("(one, 2) and (3, two)"));
    row("code", QStringLiteral("`vec(1, 2) m/s`\n\n```\nlocal v = 2 m/s (1, 2)\n```"),
        QStringLiteral("vec(1, 2) m/s\nlocal v = 2 m/s (1, 2)"));
}

void TestBoundUnits::keepsTogetherWhatIsReadInOneGo()
{
    QFETCH(QString, markdown);
    QFETCH(QString, expected);
    QCOMPARE(bound(markdown).trimmed(), expected);
}

void TestBoundUnits::keepsTheFormatOfWhatItBinds()
{
    QTextDocument document;
    document.setMarkdown(QStringLiteral("plain **2 m/s** plain 3 m"));
    bindUnits(&document);
    QTextBlock block = document.begin();
    int bold = 0;
    for (auto it = block.begin(); !it.atEnd(); ++it) {
        if (it.fragment().charFormat().fontWeight() > QFont::Normal) {
            ++bold;
            QCOMPARE(it.fragment().text(), QStringLiteral("2\u00a0m\u2060/\u2060s"));
        }
    }
    QCOMPARE(bold, 1);
}

/// At any width of the page.
void TestBoundUnits::linesNeverBreakBeforeAUnit()
{
    QTextDocument document;
    document.setMarkdown(QStringLiteral("one two 12 m/s three four 345 kg m/s five (−2, 2) m six"));
    bindUnits(&document);
    int lines = 0;
    for (int width = 120; width < 500; width += 3) {
        document.setTextWidth(width);
        (void)document.size(); // lays it out
        const QTextBlock block = document.begin();
        for (int i = 0; i < block.layout()->lineCount(); ++i) {
            const QTextLine line = block.layout()->lineAt(i);
            const QString text = block.text().mid(line.textStart(), line.textLength()).trimmed();
            for (const char *torn : {"m", "kg", "s", "2)"})
                QVERIFY2(!text.startsWith(QLatin1String(torn)) || text.startsWith(u"six"),
                         qPrintable(text));
            ++lines;
        }
    }
    QVERIFY(lines > 200); // it did break
}

QTEST_MAIN(TestBoundUnits)
#include "test_bound_units.moc"
