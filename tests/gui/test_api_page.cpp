// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_code.h"
#include "tests/patience.h"
#include "tests/test_paths.h"
#include "views/code/api_page.h"
#include "views/code/api_words.h"

#include <QFile>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTranslator>

using namespace cradle;

class TestApiPage final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }

    void everyWordHasAHeading_data();
    void everyWordHasAHeading();
    void translationHasTheSameEntries();
    void pageBeginsAtItsTop();
    void pageFollowsTheLanguage();
    void pageShowsWords();
    void pageSearches();
};

namespace {

/// The lines of a page in docs that begin with \p start.
QStringList linesOf(const QString &page, const QString &start)
{
    QFile file(sourcePath("docs/") + page);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QString::fromUtf8(file.readAll())
        .split(u'\n')
        .filter(QRegularExpression(u'^' + QRegularExpression::escape(start)));
}

/// German as far as the name of the page.
class PageName final : public QTranslator
{
public:
    [[nodiscard]] QString translate(const char *context, const char *source, const char *,
                                    int) const override
    {
        const bool name =
            qstrcmp(context, "cradle::ApiPage") == 0 && qstrcmp(source, ":/help/lua-api.md") == 0;
        return name ? s(":/help/lua-api.de.md") : QString();
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

} // namespace

void TestApiPage::everyWordHasAHeading_data()
{
    QTest::addColumn<QString>("page");
    QTest::newRow("English") << s("lua-api.md");
    QTest::newRow("German") << s("lua-api.de.md");
}

void TestApiPage::everyWordHasAHeading()
{
    QFETCH(QString, page);
    QStringList headings;
    for (const QString &line : linesOf(page, s("### ")))
        headings << line.mid(4).split(s(", "));
    for (const ApiWord &word : apiWords()) {
        const QString asked = word.owner == s("vec")  ? s("vec:") + word.name
                              : word.owner == s("xy") ? s("vec.") + word.name
                              : word.owner.isEmpty()  ? word.name
                                                      : word.owner + u'.' + word.name;
        QVERIFY2(headings.contains(asked), qPrintable(asked));
        QVERIFY2(word.kind == ApiWord::Kind::Keyword || !word.doc.isEmpty(), qPrintable(asked));
    }
}

/// What is the same in every language: the order of the entries, and how things are called.
void TestApiPage::translationHasTheSameEntries()
{
    const QStringList entries = linesOf(s("lua-api.md"), s("#"));
    const QStringList translated = linesOf(s("lua-api.de.md"), s("#"));
    QCOMPARE(translated.size(), entries.size());
    for (qsizetype i = 0; i < entries.size(); ++i) {
        const bool words = entries[i].contains(u' ') && entries[i].at(4).isUpper();
        QVERIFY2(translated[i].section(u' ', 0, 0) == entries[i].section(u' ', 0, 0),
                 qPrintable(translated[i]));
        QVERIFY2(translated[i] == entries[i] || words || entries[i].startsWith(s("## "))
                     || entries[i].startsWith(s("# ")),
                 qPrintable(translated[i]));
    }
    const auto signatures = [](const QString &page) {
        return linesOf(page, s("`")).filter(QRegularExpression(s("^`[^`]*`$")));
    };
    QVERIFY(signatures(s("lua-api.md")).size() > 20);
    QCOMPARE(signatures(s("lua-api.de.md")), signatures(s("lua-api.md")));
    QCOMPARE(linesOf(s("lua-api.de.md"), s("- ")).size(), linesOf(s("lua-api.md"), s("- ")).size());
}

void TestApiPage::pageBeginsAtItsTop()
{
    ApiPage page;
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page, patience));
    page.showWord({});
    const auto *text = page.findChild<QTextBrowser *>();
    QVERIFY(text->verticalScrollBar()->maximum() > 0);
    QCOMPARE(text->verticalScrollBar()->value(), 0);
}

void TestApiPage::pageFollowsTheLanguage()
{
    ApiPage page;
    QVERIFY(page.showWord(s("circle.mass")));
    const auto *text = page.findChild<QTextBrowser *>();
    QVERIFY(text->toPlainText().contains(s("working it out is step 14")));
    PageName german;
    QVERIFY(QCoreApplication::installTranslator(&german));
    QCoreApplication::processEvents();
    QVERIFY(text->toPlainText().contains(s("Sie auszurechnen ist Schritt 14")));
    QVERIFY(!text->toPlainText().contains(s("working it out")));
    QCOMPARE(page.currentHeading(), s("circle.mass"));
    QVERIFY(page.showWord(s("gravity")));
    QVERIFY(QCoreApplication::removeTranslator(&german));
    QCoreApplication::processEvents();
    QVERIFY(text->toPlainText().contains(s("working it out is step 14")));
    QCOMPARE(page.currentHeading(), s("gravity"));
}

void TestApiPage::pageShowsWords()
{
    ApiPage page;
    page.resize(700, 500);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page, patience));
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
    QVERIFY(QTest::qWaitForWindowActive(&page, patience));
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
