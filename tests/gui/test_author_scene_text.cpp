// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "views/theme.h"

#include <QLabel>
#include <QPlainTextEdit>

using namespace cradle;
using namespace cradle::windows;

/// A scene written as the text of its file, where numbers may be expressions.
class TestAuthorSceneText : public QObject
{
    Q_OBJECT
private slots:
    void expressionStaysAndMovesTheCircle();
    void whatCannotBeReadStaysToBeMended();
    void bothScenesHaveTheirText();
};

namespace {

const QString step = QStringLiteral("BALL1");

QPlainTextEdit *openText(OpenAuthor &author, const QTemporaryDir &folder)
{
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Scene);
    author.click(QStringLiteral("As text"));
    return author.find<QPlainTextEdit>("sceneText");
}

/// Writes \p after in place of \p before, as by keyboard.
void rewrite(QPlainTextEdit *text, const QString &before, const QString &after)
{
    QVERIFY2(text->find(before) || (text->moveCursor(QTextCursor::Start), text->find(before)),
             qPrintable(before));
    text->insertPlainText(after);
}

} // namespace

void TestAuthorSceneText::expressionStaysAndMovesTheCircle()
{
    applyTheme(ThemeChoice::Light);
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    auto *text = openText(author, folder);
    QVERIFY(text->isVisible());
    QVERIFY2(QFontInfo(text->font()).fixedPitch(), qPrintable(text->font().family()));
    QCOMPARE(author.focus(), text);
    rewrite(text, QStringLiteral("[0, 1.2]"),
            QStringLiteral("[\"20 cm\", \"1 + 0.42*cos(pi/3)\"]"));
    const Result<Preset> scene = presetOf(author.files(), step);
    QVERIFY(scene);
    QCOMPARE(scene->circles[0].body.position.x, 0.2);
    QVERIFY(std::abs(scene->circles[0].body.position.y - 1.21) < 1e-12);
    QCOMPARE(author.window.sceneTab().preset().own(), *scene);
    // Another number, set where it is seen, leaves the expressions as they are written.
    Preset faster = *scene;
    faster.circles[0].body.velocity.x = 1.5;
    author.window.sceneTab().preset().edit(QStringLiteral("Set it"), faster);
    QVERIFY(text->toPlainText().contains(QLatin1String("cos(pi/3)")));
    QVERIFY(text->toPlainText().contains(QLatin1String("1.5")));
    author.undo();
    author.undo();
    QTRY_VERIFY(text->toPlainText().contains(QLatin1String("[0, 1.2]")));
}

void TestAuthorSceneText::whatCannotBeReadStaysToBeMended()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    auto *text = openText(author, folder);
    const LabFiles before = author.files();
    rewrite(text, QStringLiteral("[0, 1.2]"), QStringLiteral("[\"2 s\", 1.2]"));
    const auto *reason = author.find<QLabel>("sceneTextReason");
    QVERIFY(reason->isVisible());
    QVERIFY2(reason->text().contains(QLatin1String("preset.json")), qPrintable(reason->text()));
    QCOMPARE(author.files(), before);
    // It waits while another step is open, and saving tells of it.
    author.document().setStep(QStringLiteral("BALL2"));
    QVERIFY(!reason->isVisible());
    author.document().setStep(step);
    QVERIFY(reason->isVisible());
    QVERIFY(text->toPlainText().contains(QLatin1String("2 s")));
    QCOMPARE(author.window.sceneTab().refusedScenes(), {QStringLiteral("BALL1/preset.json")});
    rewrite(text, QStringLiteral("2 s"), QStringLiteral("2 m"));
    QVERIFY(!reason->isVisible());
    QCOMPARE(presetOf(author.files(), step)->circles[0].body.position.x, 2.0);
}

void TestAuthorSceneText::bothScenesHaveTheirText()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    auto *text = openText(author, folder);
    QVERIFY(text->toPlainText().contains(QLatin1String("\"euler\"")));
    author.window.sceneTab().openSolution();
    QVERIFY(text->toPlainText().contains(QLatin1String("symplectic_euler")));
    author.click(QStringLiteral("As text"));
    QVERIFY(!text->isVisible());
}

QTEST_MAIN(TestAuthorSceneText)
#include "test_author_scene_text.moc"
