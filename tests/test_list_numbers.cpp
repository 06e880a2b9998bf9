// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/markdown_view.h"

#include <QTest>
#include <QTextBlock>
#include <QTextList>
#include <QTextTable>

using namespace cradle;

/// Lists and tables as CommonMark has them.
class TestListNumbers : public QObject
{
    Q_OBJECT
private slots:
    void listsBeginWithTheirNumber_data();
    void listsBeginWithTheirNumber();
    void tablesAreSet();
};

namespace {

/// What is seen: of items "1. text", of all else the text.
QStringList linesOf(const QTextDocument &document)
{
    QStringList lines;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (!block.isVisible() || block.text().isEmpty())
            continue;
        const QTextList *list = block.textList();
        lines.append(list ? QString(list->format().indent(), u' ') + list->itemText(block) + u' '
                                + block.text()
                          : block.text());
    }
    return lines;
}

} // namespace

void TestListNumbers::listsBeginWithTheirNumber_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("seen"); // lines between slashes
    QTest::newRow("from 2") << "2. a\n3. b\n"
                            << " 2. a/ 3. b";
    QTest::newRow("counts on whatever follows") << "4. a\n9. b\n"
                                                << " 4. a/ 5. b";
    QTest::newRow("from 1") << "1. a\n2. b\n"
                            << " 1. a/ 2. b";
    QTest::newRow("after a text between") << "1. a\n\ntext\n\n2. b\n"
                                          << " 1. a/text/ 2. b";
    QTest::newRow("nested") << "3. a\n   - x\n   - y\n4. b\n"
                            << " 3. a/  . x/  . y/ 4. b";
    QTest::newRow("nested numbers") << "2. a\n\n   5. x\n   6. y\n3. b\n"
                                    << " 2. a/  5. x/  6. y/ 3. b";
    QTest::newRow("no list inside a paragraph") << "In all\n2. of them\n"
                                                << "In all 2. of them";
    QTest::newRow("code") << "```\n2. a\n```\n"
                          << "2. a";
    QTest::newRow("number that begins a text") << "2. 3 circles\n"
                                               << " 2. 3 circles";
}

void TestListNumbers::listsBeginWithTheirNumber()
{
    QFETCH(QString, markdown);
    QFETCH(QString, seen);
    MarkdownView view;
    view.setMarkdown(markdown, {});
    QCOMPARE(linesOf(*view.document()).join(QLatin1Char('/')), seen);
}

void TestListNumbers::tablesAreSet()
{
    MarkdownView view;
    view.setMarkdown(QStringLiteral("| n | height |\n|---|---:|\n| 1 | 3.2 m |\n"), {});
    const auto frames = view.document()->rootFrame()->childFrames();
    QCOMPARE(frames.size(), 1);
    auto *table = qobject_cast<QTextTable *>(frames.front());
    QVERIFY(table);
    QCOMPARE(table->rows(), 2);
    QCOMPARE(table->columns(), 2);
    QVERIFY(
        table->cellAt(1, 1).firstCursorPosition().block().text().startsWith(QStringLiteral("3.2")));
}

QTEST_MAIN(TestListNumbers)

#include "test_list_numbers.moc"
