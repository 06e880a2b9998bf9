// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/values_form.h"
#include "tasks/values/lab_values.h"
#include "views/markdown_view.h"

#include <QLabel>

using namespace cradle;
using namespace cradle::windows;

/// The named values of a lab and a step, written in the author's window.
class TestAuthorValues : public QObject
{
    Q_OBJECT
private slots:
    void valueIsNamedAndUsed();
    void rangeIsDrawnForEachStudent();
    void whatIsNoValueStaysToBeMended();
    void undoTakesAllBack();
    void valueMovesToTheWholeLab();
    void findingLeadsToItsValue();
    void tabFollowsTheEye_data();
    void tabFollowsTheEye();
};

namespace {

void openValues(OpenAuthor &author, const QTemporaryDir &folder)
{
    openBall(author, folder);
    author.choose(QStringLiteral("Values of lab and step"));
    QVERIFY(author.find<QListWidget>("values")->isVisible());
}

std::vector<ValueForm> ofStep(OpenAuthor &author)
{
    return valueForms(author.files(), author.document().step());
}

void addValue(OpenAuthor &author, const char *name, const char *expression)
{
    author.click(QStringLiteral("Add a value"));
    author.fill("valueName", QLatin1String(name));
    author.fill("valueExpression", QLatin1String(expression));
}

} // namespace

void TestAuthorValues::valueIsNamedAndUsed()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openValues(author, folder);
    addValue(author, "height", "5");
    addValue(author, "speed", "sqrt(2*9.81*height)");
    QCOMPARE(author.document().step(), QStringLiteral("BALL1"));
    QCOMPARE(valuesOf(author.files(), QStringLiteral("BALL1"), {}).value(QStringLiteral("speed")),
             9.904544411531507); // √98.1
    QVERIFY(author.files().contents[QStringLiteral("BALL1/task.json")].contains("\"height\": 5"));
    const auto *facts = author.find<QLabel>("valueFacts");
    QVERIFY(facts->text().contains(QLatin1String("speed = 9.9045")));
    QVERIFY(facts->text().contains(QLatin1String("Nothing uses it yet")));
    QVERIFY(
        author.document().edit({}, withText(author.files(), QStringLiteral("BALL1/instructions.md"),
                                            QStringLiteral("It comes with {{speed}} m/s."))));
    QVERIFY(facts->text().contains(QLatin1String("Used in BALL1/instructions.md.")));
    author.find<QListWidget>("values")->setCurrentRow(0);
    QVERIFY(facts->text().contains(QLatin1String("Used in BALL1/task.json.")));
    // The preview is what the student reads.
    author.find<QComboBox>("textPart")->setCurrentIndex(0);
    QTRY_VERIFY(textShown(author.window.textTab().student())
                    .contains(QLatin1String("It comes with 9.9045444")));
}

void TestAuthorValues::rangeIsDrawnForEachStudent()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openValues(author, folder);
    addValue(author, "e", "0.6");
    auto *kind = author.find<QComboBox>("valueKind");
    kind->setCurrentIndex(1);
    emit kind->activated(1);
    QVERIFY(!author.find<QLineEdit>("valueExpression")->isVisible());
    author.fill("valueTo", QStringLiteral("0.9"));
    author.fill("valueStep", QStringLiteral("1/20"));
    QCOMPARE(
        ofStep(author).front(),
        (ValueForm{
            .name = QStringLiteral("e"), .drawn = true, .from = 0.6, .to = 0.9, .step = 0.05}));
    const auto *facts = author.find<QLabel>("valueFacts");
    QVERIFY(facts->text().contains(
        QLatin1String("one of 7 number(s): 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9.")));
    author.fill("valueStudent", QStringLiteral("4711"));
    const double drawn = valuesOf(author.files(), QStringLiteral("BALL1"), QStringLiteral("4711"))
                             .value(QStringLiteral("e"));
    QCOMPARE(author.find<QLabel>("valueDrawn")->text(),
             QStringLiteral("Student 4711 has e = %1").arg(drawn));
    author.fill("valueDraw", QStringLiteral("2027"));
    QCOMPARE(drawOf(author.files()), QStringLiteral("2027"));
    author.document().readNow();
    QVERIFY(author.document().lab().findings.empty());
}

void TestAuthorValues::whatIsNoValueStaysToBeMended()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openValues(author, folder);
    addValue(author, "k", "2*kk");
    const auto *refusal = author.find<QLabel>("valueRefusal");
    QVERIFY(refusal->isVisible());
    QVERIFY(refusal->text().contains(QLatin1String("kk")));
    QVERIFY(ofStep(author).front().expression != QLatin1String("2*kk"));
    // It stays when another value is edited, and saving tells of it.
    author.click(QStringLiteral("Add a value"));
    author.fill("valueName", QStringLiteral("n"));
    author.find<QListWidget>("values")->setCurrentRow(0);
    QCOMPARE(author.find<QLineEdit>("valueExpression")->text(), QStringLiteral("2*kk"));
    author.choose(QStringLiteral("Save"));
    QVERIFY(author.window.notice().text().contains(QLatin1String("BALL1/k")));
    author.fill("valueExpression", QStringLiteral("2*pi"));
    QVERIFY(!refusal->isVisible());
    QCOMPARE(ofStep(author).front().expression, QStringLiteral("2*pi"));
    author.fill("valueName", QStringLiteral("sin"));
    QVERIFY(refusal->isVisible());
    QCOMPARE(ofStep(author).back().name, QStringLiteral("si")); // as far as it was a name
    author.fill("valueName", QStringLiteral("n"));
    QVERIFY(refusal->text().contains(QLatin1String("already")));
}

void TestAuthorValues::undoTakesAllBack()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openValues(author, folder);
    const LabFiles before = author.files();
    addValue(author, "k", "0.75");
    author.undo(); // the number, typed in one go
    QCOMPARE(ofStep(author).front().expression, QStringLiteral("1"));
    author.undo(); // the name
    author.undo();
    QCOMPARE(author.files(), before);
    QVERIFY(!author.find<QLineEdit>("valueName")->isVisible());
    author.redo();
    author.redo();
    author.redo();
    QCOMPARE(ofStep(author).front().expression, QStringLiteral("0.75"));
    author.find<QListWidget>("values")->setFocus();
    QTest::keyClick(author.find<QListWidget>("values"), Qt::Key_Delete);
    QCOMPARE(author.files(), before); // without "values", byte for byte
}

void TestAuthorValues::valueMovesToTheWholeLab()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openValues(author, folder);
    addValue(author, "k", "0.75");
    auto *place = author.find<QComboBox>("valuePlace");
    place->setCurrentIndex(0);
    emit place->activated(0);
    QVERIFY(ofStep(author).empty());
    QCOMPARE(valueForms(author.files(), {}).size(), std::size_t(1));
    author.document().setStep(QStringLiteral("BALL2"));
    QCOMPARE(author.find<QListWidget>("values")->count(), 1);
    QCOMPARE(author.find<QLineEdit>("valueName")->text(), QStringLiteral("k"));
}

void TestAuthorValues::findingLeadsToItsValue()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openValues(author, folder);
    QVERIFY(author.document().edit(
        {}, withValueForms(author.files(), QStringLiteral("BALL2"),
                           {{.name = QStringLiteral("a"), .expression = QStringLiteral("1")},
                            {.name = QStringLiteral("b"), .expression = QStringLiteral("2*c")}})));
    author.window.panes().showTab(AuthorWindow::Scene);
    author.document().readNow();
    auto *findings = author.find<QListWidget>("authorFindings");
    QVERIFY(findings);
    QTRY_VERIFY(findings->count() > 0);
    emit findings->itemClicked(findings->item(0));
    QCOMPARE(author.document().step(), QStringLiteral("BALL2"));
    QCOMPARE(author.find<QLineEdit>("valueName")->text(), QStringLiteral("b"));
    QVERIFY(author.find<QLabel>("valueRefusal")->text().contains(QLatin1Char('c')));
}

void TestAuthorValues::tabFollowsTheEye_data()
{
    QTest::addColumn<bool>("drawn");
    QTest::addColumn<int>("fields");
    QTest::newRow("number") << false << 4; // name, kind, expression, place
    QTest::newRow("drawn") << true << 6;   // name, kind, from, to, step, place
}

/// From the name through the fields of the value, each below or right of the one before.
void TestAuthorValues::tabFollowsTheEye()
{
    QFETCH(const bool, drawn);
    QFETCH(const int, fields);
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openValues(author, folder);
    addValue(author, "e", "0.6");
    auto *name = author.find<QLineEdit>("valueName");
    if (drawn) {
        auto *kind = author.find<QComboBox>("valueKind");
        QVERIFY(kind);
        kind->setCurrentIndex(1);
        emit kind->activated(1);
    }
    QVERIFY(QTest::qWaitForWindowActive(&author.window, patience));
    name->setFocus();
    QPoint before = name->mapToGlobal(QPoint());
    QSet<QWidget *> seen{name};
    for (int i = 1; i < fields; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QWidget *now = QApplication::focusWidget();
        QVERIFY(now && name->parentWidget()->isAncestorOf(now));
        QVERIFY2(!seen.contains(now), qPrintable(now->objectName()));
        seen.insert(now);
        const QPoint at = now->mapToGlobal(QPoint());
        QVERIFY2(at.y() > before.y() || (at.y() == before.y() && at.x() > before.x()),
                 qPrintable(now->objectName()));
        before = at;
    }
}

QTEST_MAIN(TestAuthorValues)

#include "test_author_values.moc"
