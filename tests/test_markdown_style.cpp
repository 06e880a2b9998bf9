// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/markdown_view.h"
#include "views/theme.h"

#include <QFontInfo>
#include <QTest>
#include <QTextBlock>

using cradle::MarkdownView;
using cradle::ThemeChoice;

namespace {

/// The colour that the stretch of text in one format has of its own, or an invalid one.
QColor colourOf(const MarkdownView &view, const QString &text)
{
    for (auto it = view.document()->begin().begin(); !it.atEnd(); ++it) {
        const QTextCharFormat format = it.fragment().charFormat();
        if (it.fragment().text() == text && format.hasProperty(QTextFormat::ForegroundBrush))
            return format.foreground().color();
    }
    return {};
}

} // namespace

class TestMarkdownStyle : public QObject
{
    Q_OBJECT

private slots:
    void scalesHeadings();
    void coloursPartsOfVelocity_data();
    void coloursPartsOfVelocity();
    void leavesOtherWordsInColourOfText();
    void linesOfCodeBeginBelowEachOther_data();
    void linesOfCodeBeginBelowEachOther();
};

void TestMarkdownStyle::scalesHeadings()
{
    MarkdownView view;
    view.setMarkdown(QStringLiteral("# One\n\n## Two\n\ntext"), {});
    const double size = QFontInfo(view.font()).pointSizeF();
    const auto sizeOf = [&view](int i) {
        const QTextBlock block = view.document()->findBlockByNumber(i);
        return block.begin().fragment().charFormat().fontPointSize();
    };
    QCOMPARE(sizeOf(0), 1.25 * size);
    QCOMPARE(sizeOf(1), 1.05 * size);
}

void TestMarkdownStyle::coloursPartsOfVelocity_data()
{
    QTest::addColumn<QString>("word");
    QTest::addColumn<bool>("along");
    QTest::newRow("along") << QStringLiteral("along") << true;
    QTest::newRow("across") << QStringLiteral("Across") << false;
    QTest::newRow("German along") << QStringLiteral("LÄNGS") << true;
    QTest::newRow("German across") << QStringLiteral("quer") << false;
}

void TestMarkdownStyle::coloursPartsOfVelocity()
{
    QFETCH(QString, word);
    QFETCH(bool, along);
    MarkdownView view;
    view.setMarkdown(QStringLiteral("The part **%1** the normal").arg(word), {});
    for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark, ThemeChoice::Light}) {
        cradle::applyTheme(choice);
        const cradle::Theme &theme = cradle::theme();
        const QColor colour = along ? theme.along : theme.across;
        QCOMPARE(colourOf(view, word), cradle::readableOn(colour, theme.panel));
        QVERIFY(!colourOf(view, QStringLiteral("The part ")).isValid());
    }
}

void TestMarkdownStyle::leavesOtherWordsInColourOfText()
{
    MarkdownView view;
    view.setMarkdown(QStringLiteral("across **alongside** *along* `quer` **`across`**\n\n## Along"),
                     {});
    for (QTextBlock block = view.document()->begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it)
            QVERIFY(!it.fragment().charFormat().hasProperty(QTextFormat::ForegroundBrush));
    }
}

void TestMarkdownStyle::linesOfCodeBeginBelowEachOther_data()
{
    QTest::addColumn<QString>("before");
    QTest::newRow("in the text") << QString();
    QTest::newRow("in a list") << QStringLiteral("   ");
}

void TestMarkdownStyle::linesOfCodeBeginBelowEachOther()
{
    QFETCH(QString, before);
    MarkdownView view;
    view.resize(400, 300);
    QString text = QStringLiteral("1. item\n\n");
    for (const char *line :
         {"```lua", "local a = 1", "local b = 2", "  inner = 3", "local c = 4", "```"})
        text += before + QLatin1String(line) + QLatin1Char('\n');
    view.setMarkdown(text + QStringLiteral("\nafter\n"), {});
    view.show();
    QList<int> starts;
    int inner = 0;
    for (QTextBlock block = view.document()->begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        if (block.text().startsWith(QStringLiteral("local")))
            starts.append(view.cursorRect(cursor).left());
        if (block.text().trimmed().startsWith(QStringLiteral("inner"))) {
            cursor.setPosition(block.position() + 2);
            inner = view.cursorRect(cursor).left();
        }
    }
    QCOMPARE(starts.size(), 3);
    QCOMPARE(starts[1], starts[0]);
    QCOMPARE(starts[2], starts[0]);
    QVERIFY(inner > starts[0]);
}

QTEST_MAIN(TestMarkdownStyle)
#include "test_markdown_style.moc"
