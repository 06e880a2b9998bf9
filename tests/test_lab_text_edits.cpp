// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_reader.h"

#include "tests/authoring_labs.h"

using namespace cradle;
using namespace cradle::authoring;

Q_DECLARE_METATYPE(cradle::LabFiles)

namespace {

const QString masses = text("L42T14"); // it has remarks

} // namespace

/// Edits of the checks and of the texts in other languages.
class TestLabTextEdits : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void checksAreAddedMovedAndRemoved();
    void translationTakesTheTextsAlone();
    void newTranslationHoldsWhatIsTranslated();
    void textsFollowARenamedCheck();
    void predictionIsTranslatedAsAWhole();
    void answersComeAndGoInAllLanguages();
    void predictionOutOfItsBoundsIsRefused();

private:
    LabFiles m_lab;
};

void TestLabTextEdits::initTestCase()
{
    TAKE(m_lab, readLabFiles(shippedFolder));
    QVERIFY(m_lab.contents.size() > 200);
}

void TestLabTextEdits::checksAreAddedMovedAndRemoved()
{
    const QString path = masses + text("/task.json");
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses));
    const std::vector<CheckForm> checks = form.checks;
    form.checks.insert(form.checks.begin() + 1,
                       CheckForm{.id = text("new"),
                                 .kind = text("settles"),
                                 .title = text("It comes to rest"),
                                 .circles = {1},
                                 .parameters = {{text("tolerance"), 1e-3}},
                                 .scene = {{text("kind"), text("drop")}, {text("count"), 5}}});
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form));
    QCOMPARE(
        newLines(m_lab.contents[path], lab.contents[path]),
        (QList<QByteArray>{"    {\"id\": \"new\", \"kind\": \"settles\", \"title\": \"It comes to "
                           "rest\", \"circles\": [2], \"parameters\": {\"tolerance\": 0.001}, "
                           "\"scene\": {\"kind\": \"drop\", \"count\": 5}},"}));
    std::swap(form.checks[0], form.checks[2]);
    TAKE(lab, withTask(lab, masses, form));
    TaskForm again;
    TAKE(again, taskForm(lab, masses));
    QVERIFY(again == form);
    form.checks = checks;
    TAKE(lab, withTask(lab, masses, form));
    QCOMPARE(differences(m_lab, lab), QStringList());
    form.checks.clear();
    TAKE(lab, withTask(lab, masses, form));
    QVERIFY(lab.contents[path].contains("\"checks\": []"));
    form.checks = {checks[0]};
    TAKE(lab, withTask(lab, masses, form));
    QVERIFY(lab.contents[path].contains("\"checks\": [\n    {\"id\": \"start-1\", "));
}

void TestLabTextEdits::translationTakesTheTextsAlone()
{
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses, text("de")));
    form.title = text("Größer");
    form.checks[1].title = text("Eine Prüfung");
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form, text("de")));
    const QString german = masses + text("/task.de.json");
    QCOMPARE(differences(m_lab, lab), QStringList{german});
    QCOMPARE(newLines(m_lab.contents[german], lab.contents[german]).size(), 2);
    // What is no text belongs to all languages.
    form.checks[1].circles = {0};
    form.commit = text("Committed");
    TAKE(lab, withTask(lab, masses, form, text("de")));
    QCOMPARE(differences(m_lab, lab), (QStringList{german, masses + text("/task.json")}));
    TaskForm english;
    TAKE(english, taskForm(lab, masses));
    QCOMPARE(english.title, taskForm(m_lab, masses)->title);
    QCOMPARE(english.checks[1].title, taskForm(m_lab, masses)->checks[1].title);
    QCOMPARE(english.checks[1].circles, std::vector<int>{0});
    QCOMPARE(english.commit, text("Committed"));
}

void TestLabTextEdits::newTranslationHoldsWhatIsTranslated()
{
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses, text("fr")));
    form.checks[1].title = text("Une preuve");
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form, text("fr")));
    QCOMPARE(lab.contents.value(masses + text("/task.fr.json")),
             QByteArray("{\n  \"checks\": {\n    \"start-2\": \"Une preuve\"\n  }\n}\n"));
    QCOMPARE(languagesOf(lab), (QStringList{text("en"), text("de"), text("fr")}));
    QVERIFY(readLab(lab, text("lab"), text("fr"))->findings.empty());
}

void TestLabTextEdits::textsFollowARenamedCheck()
{
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses));
    form.checks[0].id = text("begin-1");
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form));
    const TaskForm before = *taskForm(m_lab, masses, text("de"));
    TaskForm german;
    TAKE(german, taskForm(lab, masses, text("de")));
    QCOMPARE(german.checks[0].title, before.checks[0].title);
    QVERIFY(!lab.contents[masses + text("/task.de.json")].contains("\"start-1\""));
    // One that is gone takes its text with it.
    form.checks.erase(form.checks.begin());
    TAKE(lab, withTask(lab, masses, form));
    QVERIFY(!lab.contents[masses + text("/task.de.json")].contains("begin-1"));
}

void TestLabTextEdits::predictionIsTranslatedAsAWhole()
{
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses, text("fr")));
    form.prediction->question = text("Quoi ?");
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form, text("fr")));
    const QString french = masses + text("/task.fr.json");
    QCOMPARE(differences(m_lab, lab), QStringList{french});
    TaskForm again;
    TAKE(again, taskForm(lab, masses, text("fr")));
    QCOMPARE(again.prediction->question, text("Quoi ?"));
    QCOMPARE(again.prediction->answers, taskForm(m_lab, masses)->prediction->answers);
    QVERIFY(readLab(lab, text("lab"), text("fr"))->findings.empty());
    // The answer that comes true is no text.
    form = again;
    form.prediction->right = (form.prediction->right + 1) % 2;
    const LabFiles before = lab;
    TAKE(lab, withTask(lab, masses, form, text("fr")));
    QCOMPARE(differences(before, lab), QStringList{masses + text("/task.json")});
    QCOMPARE(taskForm(lab, masses)->prediction->right, form.prediction->right);
}

void TestLabTextEdits::answersComeAndGoInAllLanguages()
{
    const Prediction english = *taskForm(m_lab, masses)->prediction;
    const Prediction german = *taskForm(m_lab, masses, text("de"))->prediction;
    QVERIFY(english.answers.size() >= 3 && english.answers != german.answers);
    // Removed in one language, it is gone in the other.
    for (const char *language : {"en", "de"}) {
        TaskForm form;
        TAKE(form, taskForm(m_lab, masses, text(language)));
        form.prediction->answers.removeAt(1);
        form.prediction->right = 0;
        LabFiles lab;
        TAKE(lab, withTask(m_lab, masses, form, text(language)));
        QStringList left = english.answers;
        left.removeAt(1);
        QCOMPARE(taskForm(lab, masses)->prediction->answers, left);
        left = german.answers;
        left.removeAt(1);
        QCOMPARE(taskForm(lab, masses, text("de"))->prediction->answers, left);
        QVERIFY(lab.contents[masses + text("/task.de.json")].contains(left[0].toUtf8()));
        // One more is there in both, in the words that were typed.
        form.prediction->answers.append(text("Never"));
        TAKE(lab, withTask(lab, masses, form, text(language)));
        QCOMPARE(taskForm(lab, masses)->prediction->answers.last(), text("Never"));
        left.append(text("Never"));
        QCOMPARE(taskForm(lab, masses, text("de"))->prediction->answers, left);
        QVERIFY(readLab(lab, text("lab"), text("de"))->findings.empty());
        // Without a prediction no language has one.
        form.prediction.reset();
        TAKE(lab, withTask(lab, masses, form, text(language)));
        QVERIFY(!lab.contents[masses + text("/task.json")].contains("prediction"));
        QVERIFY(!lab.contents[masses + text("/task.de.json")].contains("prediction"));
        // And asked for anew, all have it.
        form.prediction = german;
        TAKE(lab, withTask(lab, masses, form, text(language)));
        QVERIFY(*taskForm(lab, masses)->prediction == german);
        QVERIFY(*taskForm(lab, masses, text("de"))->prediction == german);
    }
}

void TestLabTextEdits::predictionOutOfItsBoundsIsRefused()
{
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses));
    form.prediction->answers = {text("only one")};
    Result<LabFiles> lab = withTask(m_lab, masses, form);
    QVERIFY(!lab);
    QCOMPARE(lab.error().pointer, text("/prediction/answers"));
    TAKE(form, taskForm(m_lab, masses));
    form.prediction->outcome.clear();
    lab = withTask(m_lab, masses, form);
    QVERIFY(!lab);
    QCOMPARE(lab.error().pointer, text("/prediction/outcome"));
}

QTEST_GUILESS_MAIN(TestLabTextEdits)
#include "test_lab_text_edits.moc"
