// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_labs.h"
#include "tests/lab_copies.h"

#include "model/files/preset_json.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/lab_search.h"
#include "tasks/authoring/student_edition.h"
#include "tasks/authoring/text_gaps.h"
#include "tasks/authoring/values_form.h"
#include "tasks/lab_report/markdown_html.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/text/formula_text.h"
#include "tasks/text/plain_text.h"
#include "tasks/text/unified_diff.h"

#include <QTest>

using namespace cradle;
using approved::u;
using approved::verifyLabs;

/// What authors are told and what their edits make of files, whole: tests/approved/labs.
class TestApprovedLabs : public QObject
{
    Q_OBJECT
private slots:
    void brokenLabsAreToldAsApproved();
    void brokenScenesAreToldAsApproved();
    void editsAreAsApproved();
    void studentEditionIsAsApproved();
    void textsAreAsApproved();
};

namespace {

QStringList entries(const char *folder)
{
    return QDir(fixturePath(folder)).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
}

/// The lab of the bouncing ball, edited in turn; what each edit makes of its files is written down.
class Edited
{
public:
    Edited()
        : m_files(*readLabFiles(sourcePath("tasks/labs/bouncing-ball")))
    {
    }
    const LabFiles &files() const { return m_files; }
    void take(const char *name, const Result<LabFiles> &edited)
    {
        m_all += QStringLiteral("== ") + u(name) + QLatin1Char('\n');
        if (!edited) {
            m_all += edited.error().toString() + QLatin1Char('\n');
            return;
        }
        QStringList paths = m_files.contents.keys() + edited->contents.keys();
        paths.removeDuplicates();
        paths.sort();
        for (const QString &path : paths) {
            const QByteArray before = m_files.contents.value(path);
            const QByteArray after = edited->contents.value(path);
            if (before == after
                && m_files.contents.contains(path) == edited->contents.contains(path))
                continue;
            m_all += path + QLatin1Char('\n');
            if (before.isEmpty() || after.isEmpty())
                m_all +=
                    QStringLiteral("  %1 bytes, then %2\n").arg(before.size()).arg(after.size());
            else
                m_all += unifiedDiff(QString::fromUtf8(before), QString::fromUtf8(after), 1);
        }
        m_files = *edited;
    }
    QString all() const { return m_all; }

private:
    LabFiles m_files;
    QString m_all;
};

} // namespace

void TestApprovedLabs::brokenLabsAreToldAsApproved()
{
    QString all;
    for (const QString &name : entries("labs")) {
        all += QStringLiteral("== ") + name + QLatin1Char('\n');
        const Result<Lab> lab = readLab(fixturePath("labs/") + name);
        if (!lab) {
            all += lab.error().toString() + QLatin1Char('\n');
            continue;
        }
        for (const Error &finding : lab->findings)
            all += finding.toString() + QLatin1Char('\n');
        for (const Task &task : lab->tasks)
            all += QStringLiteral("%1 %2 %3\n").arg(task.id, task.title).arg(task.checks.size());
    }
    for (const char *path :
         {"S1/task.json", "a/b/c/d/e/f", "a/b/c/d/e/f/g", "../x", "a//b", ".git/x", "con",
          "a/NUL.lua", "a b/c", "ä/ö.md", "a\\b", "a:b", "a.", " a"})
        all += QStringLiteral("%1 %2\n").arg(u(path), faultOfLabPath(u(path)));
    verifyLabs("broken-labs.txt", all);
}

void TestApprovedLabs::brokenScenesAreToldAsApproved()
{
    QString all;
    for (const char *folder : {"presets/bad", "presets/good"}) {
        for (const QString &name : entries(folder)) {
            const auto preset = readPreset(fixturePath(folder) + QLatin1Char('/') + name);
            all += preset ? QString::fromUtf8(writePreset(*preset))
                          : preset.error().toString() + QLatin1Char('\n');
        }
    }
    verifyLabs("scenes.txt", all);
}

void TestApprovedLabs::editsAreAsApproved()
{
    Edited lab;
    const QString first = u("BALL1");
    const QString second = u("BALL2");
    lab.take("title", withLab(lab.files(), {u("ball"), u("A ball"), u("3"), u("en")}));
    lab.take("title in Spanish",
             withLab(lab.files(), {u("ball"), u("Una bola"), u("3"), u("en")}, u("es")));
    lab.take("own language", withOwnLanguage(lab.files(), u("de")));
    lab.take("step added", withStepAdded(lab.files(), u("BALL9"), u("A new one"), 1));
    lab.take("step added again", withStepAdded(lab.files(), u("BALL9"), u("A new one")));
    lab.take("step moved", withStepMoved(lab.files(), u("BALL9"), 2));
    lab.take("step renamed", withStepRenamed(lab.files(), u("BALL9"), u("BALL8")));
    lab.take("step duplicated", withStepDuplicated(lab.files(), first, u("BALL7")));
    lab.take("step removed", withStepRemoved(lab.files(), u("BALL8")));
    Result<TaskForm> form = taskForm(lab.files(), first);
    QVERIFY(form.ok());
    form->title = u("Let it fall");
    form->hints.append(u("One hint more"));
    form->extra = true;
    form->points = 2.5;
    form->locked = {u("gravity")};
    form->checks[0].title = u("It starts");
    form->checks[0].points = 2.0;
    form->checks.push_back({.id = u("stays"), .kind = u("stays_inside"), .title = u("It stays")});
    lab.take("task", withTask(lab.files(), first, *form));
    form->checks.erase(form->checks.begin());
    form->hints.clear();
    form->prediction = Prediction{.question = u("Where?"),
                                  .answers = {u("here"), u("there")},
                                  .right = 1,
                                  .outcome = u("There.")};
    form->questions = {{.id = u("v"),
                        .kind = Question::Kind::Number,
                        .title = u("Speed"),
                        .text = u("How fast?"),
                        .number = 9.9,
                        .tolerance = 0.1,
                        .unit = u("m/s")},
                       {.id = u("which"),
                        .kind = Question::Kind::Several,
                        .title = u("Which"),
                        .text = u("Which are right?"),
                        .answers = {u("a"), u("b"), u("c")},
                        .chosen = {0, 2}},
                       {.id = u("last"),
                        .kind = Question::Kind::One,
                        .title = u("One"),
                        .text = u("Which is right?"),
                        .answers = {u("a"), u("b")},
                        .chosen = {1}}};
    lab.take("task with questions", withTask(lab.files(), first, *form));
    form = taskForm(lab.files(), first, u("de"));
    QVERIFY(form.ok());
    form->title = u("Lass ihn fallen");
    form->checks[0].title = u("Er bleibt");
    lab.take("task in German", withTask(lab.files(), first, *form, u("de")));
    Result<Preset> scene = presetOf(lab.files(), second);
    QVERIFY(scene.ok());
    scene->gravity.y = -1.62;
    scene->circles[0].body.radius = 0.25;
    lab.take("scene", withPreset(lab.files(), second, *scene));
    lab.take("scene that passes", withPreset(lab.files(), second, *scene, StepPreset::Solution));
    const QString mistake = knownNames(lab.files(), second, KnownKind::Mistake).constFirst();
    const QString solution = *programText(lab.files(), u("BALL2/solution.lua"));
    lab.take("mistake renamed",
             withKnownRenamed(lab.files(), second, KnownKind::Mistake, mistake, u("other")));
    lab.take("mistake added", withKnownAdded(lab.files(), second, KnownKind::Mistake, u("new"),
                                             u("-- Too slow\n\n") + solution));
    lab.take("mistake in German", withKnownText(lab.files(), second, KnownKind::Mistake, u("new"),
                                                u("de"), u("Zu langsam")));
    lab.take("mistake removed",
             withKnownRemoved(lab.files(), second, KnownKind::Mistake, u("other")));
    lab.take("solution",
             withProgramText(lab.files(), u("BALL2/solution.lua"), u("-- by hand\n") + solution));
    lab.take("text", withText(lab.files(), instructionsPath(lab.files(), first), u("# New\n")));
    lab.take("search",
             replacedInLab(lab.files(), {.text = u("ball"), .wholeWords = true, .step = u("BALL3")},
                           u("disc")));
    lab.take("values", withValueForms(
                           lab.files(), first,
                           {{.name = u("g"), .expression = u("9.81 m/s^2")},
                            {.name = u("k"), .drawn = true, .from = 0.5, .to = 0.9, .step = 0.1}}));
    lab.take("differences", withDifferences(lab.files()));
    QString all = lab.all();
    for (const Error &gap : textGaps(lab.files()))
        all += gap.toString() + QLatin1Char('\n');
    for (const LabHit &hit : findInLab(lab.files(), {.text = u("gravity")}))
        all += QStringLiteral("%1:%2 %3 %4 %5 %6\n")
                   .arg(hit.path)
                   .arg(hit.line)
                   .arg(hit.pointer, hit.text)
                   .arg(hit.at)
                   .arg(hit.count);
    verifyLabs("edits.txt", all);
}

void TestApprovedLabs::studentEditionIsAsApproved()
{
    const LabFiles whole = *readLabFiles(sourcePath("tasks/labs/bouncing-ball"));
    const auto edition = studentEdition(whole);
    QVERIFY(edition.ok());
    QString all = QStringLiteral("%1 left out; %2\n")
                      .arg(edition->left)
                      .arg(edition->unexplained.join(QLatin1Char(' ')));
    for (auto it = edition->files.contents.cbegin(); it != edition->files.contents.cend(); ++it) {
        all += QStringLiteral("== ") + it.key() + QLatin1Char('\n');
        if (it.value() != whole.contents.value(it.key()))
            all += QString::fromUtf8(it.value());
    }
    verifyLabs("student-edition.txt", all);
}

void TestApprovedLabs::textsAreAsApproved()
{
    QString all;
    for (const char *name : {"BALL1/instructions.md", "BALL3/instructions.md"}) {
        const LabFiles files = *readLabFiles(sourcePath("tasks/labs/bouncing-ball"));
        const QString text = textOf(files, QString::fromLatin1(name));
        all += QStringLiteral("== ") + u(name) + QLatin1Char('\n') + plainText(text, 60)
               + QLatin1Char('\n') + markdownHtml(text) + QLatin1Char('\n');
    }
    const QString text = approved::read(QStringLiteral("labs/text.md"));
    QVERIFY(!text.isEmpty());
    all += plainText(text, 40) + QLatin1Char('\n') + markdownHtml(text) + QLatin1Char('\n')
           + withPlainFormulas(text) + QLatin1Char('\n');
    const FormulaText found = findFormulas(text);
    for (const FormulaSource &formula : found.formulas)
        all += QStringLiteral("%1 | %2 | %3 | %4 | %5\n")
                   .arg(formula.tex, formula.markdown)
                   .arg(int(formula.display))
                   .arg(formula.before, formula.after);
    verifyLabs("texts.txt", all + found.markdown);
}

QTEST_GUILESS_MAIN(TestApprovedLabs)
#include "test_approved_labs.moc"
