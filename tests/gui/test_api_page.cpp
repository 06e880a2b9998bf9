// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_code.h"
#include "views/code/api_page.h"
#include "views/code/api_words.h"

#include <QFile>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>

using namespace cradle;

class TestApiPage final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }

    void everyWordHasAHeading();
    void pageShowsWords();
    void pageSearches();
};

void TestApiPage::everyWordHasAHeading()
{
    QFile file(s(CRADLE_SOURCE_DIR "/docs/lua-api.md"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QStringList headings;
    for (const QString &line : QString::fromUtf8(file.readAll()).split(u'\n')) {
        if (line.startsWith(s("### ")))
            headings << line.mid(4).split(s(", "));
    }
    for (const ApiWord &word : apiWords()) {
        const QString asked = word.owner == s("vec")  ? s("vec:") + word.name
                              : word.owner == s("xy") ? s("vec.") + word.name
                              : word.owner.isEmpty()  ? word.name
                                                      : word.owner + u'.' + word.name;
        QVERIFY2(headings.contains(asked), qPrintable(asked));
        QVERIFY2(word.kind == ApiWord::Kind::Keyword || !word.doc.isEmpty(), qPrintable(asked));
    }
}

void TestApiPage::pageShowsWords()
{
    ApiPage page;
    page.resize(700, 500);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    const auto at = [&page](const char *word) {
        return page.showWord(s(word)) ? page.currentHeading() : QString();
    };
    QCOMPARE(at("circle1"), s("circle1, circle2"));
    QCOMPARE(at("circle17"), s("circles"));
    QCOMPARE(at("length"), s("vec:length"));
    QCOMPARE(at("position"), s("circle.position"));
    QCOMPARE(at("mass"), s("circle.mass"));
    QCOMPARE(at("x"), s("vec.x, vec.y"));
    QCOMPARE(at("math.sqrt"), s("math.sqrt, math.abs"));
    QCOMPARE(at("insert"), s("table.insert"));
    QCOMPARE(at("elseif"), s("if, then, elseif, else, end"));
    QCOMPARE(at("frobnicate"), QString());
    page.showWord(s("gravity"));
    auto *text = page.findChild<QTextBrowser *>();
    QVERIFY(text->verticalScrollBar()->value() > 500);
    const QString seen = text->cursorForPosition(QPoint(60, 20)).block().text();
    QCOMPARE(seen, s("gravity"));
}

void TestApiPage::pageSearches()
{
    ApiPage page;
    page.show();
    page.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&page));
    auto *field = page.findChild<QLineEdit *>();
    field->setFocus();
    QTest::keyClicks(field, s("restit"));
    QCOMPARE(page.currentHeading(), s("restitution"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(page.findChild<QTextBrowser *>()->textCursor().selectedText().toLower(), s("restit"));
    field->clear();
    QTest::keyClicks(field, s("qqq"));
    bool said = false;
    for (const auto *label : page.findChildren<QLabel *>())
        said = said || (label->isVisible() && label->text().endsWith(s("qqq")));
    QVERIFY(said);
    QTest::keyClick(field, Qt::Key_Escape);
    QVERIFY(field->text().isEmpty());
}

QTEST_MAIN(TestApiPage)
#include "test_api_page.moc"
