// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/authoring_labs.h"

#include "tasks/authoring/text_gaps.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/script/program_tokens.h"

using namespace cradle;
using namespace cradle::authoring;

/// Texts of a lab in several languages are edited each in its file, and stay together.
class TestLabTranslations : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void translationTakesTheTextsAlone();
    void newTranslationHoldsWhatIsTranslated();
    void textsFollowARenamedCheck();
    void titleOfTheLabComesAndGoesInALanguage();
    void languageOfTheLabIsNoneThatItIsTranslatedInto();
    void predictionIsTranslatedAsAWhole();
    void answersComeAndGoInAllLanguages();
    void predictionOutOfItsBoundsIsRefused();
    void startersSpeakEveryLanguage();
    void starterOfAnotherLanguageIsAFileOfTheLab();

private:
    LabFiles m_lab;
};

namespace {

const QString masses = text("L42T14"); // it has remarks and a prediction

} // namespace

void TestLabTranslations::initTestCase()
{
    TAKE(m_lab, readLabFiles(shippedFolder));
    for (const QString &name : m_lab.contents.keys()) { // two languages are enough to tell apart
        if (name.contains(text(".fr.")) || name.contains(text(".ar.")))
            m_lab.contents.remove(name);
    }
}

void TestLabTranslations::translationTakesTheTextsAlone()
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

void TestLabTranslations::newTranslationHoldsWhatIsTranslated()
{
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses, text("it")));
    form.checks[1].title = text("Una prova");
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form, text("it")));
    QCOMPARE(lab.contents.value(masses + text("/task.it.json")),
             QByteArray("{\n  \"checks\": {\n    \"start-2\": \"Una prova\"\n  }\n}\n"));
    QCOMPARE(languagesOf(lab), (QStringList{text("en"), text("de"), text("it")}));
    QVERIFY(readLab(lab, text("lab"), text("it"))->findings.empty());
}

void TestLabTranslations::textsFollowARenamedCheck()
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

void TestLabTranslations::titleOfTheLabComesAndGoesInALanguage()
{
    QVERIFY(hasTitle(m_lab, text("en")) && hasTitle(m_lab, text("de")));
    QVERIFY(!hasTitle(m_lab, text("it")));
    LabForm form;
    TAKE(form, labForm(m_lab, text("it")));
    QCOMPARE(form.title, labForm(m_lab)->title);
    // Not translated is no translation, also if it is said so.
    form.title.clear();
    LabFiles lab;
    TAKE(lab, withLab(m_lab, form, text("it")));
    QCOMPARE(differences(m_lab, lab), QStringList());
    form.title = text("Palline");
    TAKE(lab, withLab(m_lab, form, text("it")));
    QCOMPARE(lab.contents.value(text("lab.it.json")),
             QByteArray("{\n  \"title\": \"Palline\"\n}\n"));
    QVERIFY(hasTitle(lab, text("it")));
    form.title.clear();
    TAKE(lab, withLab(lab, form, text("it")));
    QCOMPARE(differences(m_lab, lab), QStringList()); // no empty file is left
}

void TestLabTranslations::languageOfTheLabIsNoneThatItIsTranslatedInto()
{
    const Result<LabFiles> german = withOwnLanguage(m_lab, text("de"));
    QVERIFY(!german);
    QVERIFY(german.error().file.contains(text(".de.")));
    LabFiles lab;
    TAKE(lab, withOwnLanguage(m_lab, text("en"))); // it is
    QCOMPARE(differences(m_lab, lab), QStringList());
    TAKE(lab, withOwnLanguage(m_lab, text("it")));
    QCOMPARE(differences(m_lab, lab), QStringList{text("lab.json")});
    QCOMPARE(languagesOf(lab), (QStringList{text("it"), text("de")}));
    const Result<LabFiles> none = withOwnLanguage(m_lab, text("italiano"));
    QVERIFY(!none);
    QCOMPARE(none.error().pointer, text("/language"));
}

void TestLabTranslations::predictionIsTranslatedAsAWhole()
{
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses, text("it")));
    form.prediction->question = text("Che cosa?");
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form, text("it")));
    const QString italian = masses + text("/task.it.json");
    QCOMPARE(differences(m_lab, lab), QStringList{italian});
    TaskForm again;
    TAKE(again, taskForm(lab, masses, text("it")));
    QCOMPARE(again.prediction->question, text("Che cosa?"));
    QCOMPARE(again.prediction->answers, taskForm(m_lab, masses)->prediction->answers);
    QVERIFY(readLab(lab, text("lab"), text("it"))->findings.empty());
    // The answer that comes true is no text.
    form = again;
    form.prediction->right = (form.prediction->right + 1) % 2;
    const LabFiles before = lab;
    TAKE(lab, withTask(lab, masses, form, text("it")));
    QCOMPARE(differences(before, lab), QStringList{masses + text("/task.json")});
    QCOMPARE(taskForm(lab, masses)->prediction->right, form.prediction->right);
}

void TestLabTranslations::answersComeAndGoInAllLanguages()
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

void TestLabTranslations::predictionOutOfItsBoundsIsRefused()
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

/// The first program that a student sees, in both shipped labs: one code, other comments.
void TestLabTranslations::startersSpeakEveryLanguage()
{
    for (const char *folder : {"tasks/labs/lab-4.2", "tasks/labs/bouncing-ball"}) {
        const QString english = readLab(sourcePath(folder))->tasks.front().starter;
        for (const char *language : {"de", "fr", "ar"}) {
            const Result<Lab> lab = readLab(sourcePath(folder), text(language));
            const QString starter = lab->tasks.front().starter;
            QVERIFY2(starter != english, language);
            const auto words = programTokens(starter);
            const auto wanted = programTokens(english);
            QVERIFY2(std::equal(words.begin(), words.end(), wanted.begin(), wanted.end(),
                                [](const ProgramToken &a, const ProgramToken &b) {
                                    return a.text == b.text;
                                }),
                     language);
        }
        QCOMPARE(readLab(sourcePath(folder), text("it"))->tasks.front().starter, english);
        const LabFiles files = *readLabFiles(sourcePath(folder));
        QVERIFY(textGaps(files).empty());
    }
}

void TestLabTranslations::starterOfAnotherLanguageIsAFileOfTheLab()
{
    LabFiles lab = m_lab;
    const QString first = text("L42T1/starter.it.lua");
    lab.contents[first] = lab.contents[text("L42T1/starter.lua")];
    QVERIFY(languagesOf(lab).contains(text("it")));
    QVERIFY(foreignFiles(lab, text("L42T1")).isEmpty());
    const auto isTold = [&](const char *part) {
        const std::vector<Error> gaps = textGaps(lab);
        return std::any_of(gaps.begin(), gaps.end(), [&](const Error &gap) {
            return gap.file == first && gap.message.contains(text(part));
        });
    };
    QVERIFY(!isTold("code"));
    lab.contents[first].replace("on_load", "at_load");
    QVERIFY(isTold("its code is not that of starter.lua"));
    lab.contents[first].replace("at_load", "on_load");
    lab.contents.insert(text("L42T2/starter.lua"), "-- begins anew\n");
    lab.contents.insert(text("L42T2/task.it.json"), "{}");
    const std::vector<Error> gaps = textGaps(lab);
    QVERIFY(std::any_of(gaps.begin(), gaps.end(), [](const Error &gap) {
        return gap.file == text("L42T2/starter.it.lua")
               && gap.message.contains(text("the starter's comments"));
    }));
}

QTEST_GUILESS_MAIN(TestLabTranslations)
#include "test_lab_translations.moc"
