// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/calm.h"
#include "tests/gui/open_window.h"
#include "tests/gui/pseudo_language.h"
#include "views/task_pane/instructions_pane.h"
#include "views/task_pane/result_pane.h"

#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

using namespace cradle;
using namespace cradle::windows;

namespace {

/// Whether it has a word: symbols and numbers are the same in every language.
bool hasWord(QString text)
{
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{4,}"));
    return text.remove(QLatin1Char('&')).contains(word);
}

} // namespace

/// What the window says in a language that nobody speaks.
class TestPseudoLanguage final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void everyTextCanBeTranslated_data();
    void everyTextCanBeTranslated();
    void languagesAreFound();

private:
    QTemporaryDir m_folder;
};

void TestPseudoLanguage::everyTextCanBeTranslated_data()
{
    QTest::addColumn<Mode>("mode");
    QTest::newRow("explore") << Mode::Explore;
    QTest::newRow("code") << Mode::Code;
}

void TestPseudoLanguage::everyTextCanBeTranslated()
{
    QFETCH(Mode, mode);
    PseudoLanguage pseudo;
    QVERIFY(QCoreApplication::installTranslator(&pseudo));
    OpenWindow open(m_folder);
    open.bench.openTask(QStringLiteral("L42T11"));
    open.bench.setMode(mode);
    open.window.resize(1440, 900);
    calm(open.window);
    QStringList plain;
    const auto look = [&](const QString &text) {
        if (hasWord(text) && !text.contains(QLatin1Char('[')))
            plain << text;
    };
    for (auto *each : open.window.findChildren<QWidget *>()) {
        // What the lab says has files of its own.
        bool ofLab = false;
        for (const QWidget *w = each; w; w = w->parentWidget())
            ofLab = ofLab || qobject_cast<const InstructionsPane *>(w)
                    || qobject_cast<const ResultPane *>(w);
        if (ofLab || !each->isVisible())
            continue;
        if (qobject_cast<QLabel *>(each) || qobject_cast<QAbstractButton *>(each)) {
            const QString text = each->property("text").toString();
            if (!text.contains(open.bench.task()->title))
                look(text);
        }
        look(each->toolTip().contains(open.bench.task()->title) ? QString() : each->toolTip());
        look(each->accessibleName());
    }
    // The names of examples, labs and languages are not the interface's.
    for (const QMenu *menu :
         open.window.menuBar()->findChildren<QMenu *>(QString(), Qt::FindDirectChildrenOnly)) {
        look(menu->title());
        for (const QAction *action : menu->actions())
            look(action->text());
    }
    plain.removeDuplicates();
    QVERIFY2(plain.isEmpty(), qPrintable(plain.join(QLatin1Char('\n'))));
    QCoreApplication::removeTranslator(&pseudo);
}

void TestPseudoLanguage::languagesAreFound()
{
    QVERIFY(languages().startsWith(QStringLiteral("en")));
    QVERIFY(languages().contains(QStringLiteral("de")));
    QCOMPARE(languageName(QStringLiteral("de")), QStringLiteral("Deutsch"));
    QCOMPARE(languageName(QStringLiteral("fr")), QStringLiteral("Français"));
    QCOMPARE(languageName(QStringLiteral("en")), QStringLiteral("English"));
}

QTEST_MAIN(TestPseudoLanguage)

#include "test_pseudo_language.moc"
