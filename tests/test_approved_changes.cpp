// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_programs.h"
#include "tests/text_print.h"

#include "tasks/judging/last_assignment.h"
#include "tasks/judging/line_guess.h"
#include "tasks/judging/push_origin.h"
#include "tasks/judging/repair_order.h"
#include "tasks/judging/value_origin.h"
#include "tasks/judging/value_repairs.h"

using namespace cradle;

/// What is read in a program's text and tried to mend it: hashes of all changes, values and
/// questions of each line of the programs of tests/approved, part by part, and the lines that are
/// guessed to be at fault, in
/// tests/approved/changes.
class TestApprovedChanges : public QObject
{
    Q_OBJECT
private slots:
    void changesAreAsApproved_data() { approved::addSteps(); }
    void changesAreAsApproved();
};

namespace {

constexpr Aspect aspects[] = {Aspect::Motion, Aspect::Walls, Aspect::Contact, Aspect::Response};
constexpr Suspect suspects[] = {Suspect::Answer, Suspect::Formula, Suspect::Question,
                                Suspect::Reach,  Suspect::Masses,  Suspect::Copy,
                                Suspect::Kept,   Suspect::Omission};

using Print = approved::TextPrint;

/// The first step in which a velocity is changed otherwise than before, or the first.
qint64 firstTurn(const QString &program, const Stage &stage)
{
    Probe probe(&program, stage, true);
    Vec2 change{};
    for (qint64 step = 1; step < 400; ++step) {
        const Vec2 before = probe.circle(0).velocity;
        if (!probe.step())
            break;
        const Vec2 now = probe.circle(0).velocity - before;
        if (step > 1 && length(now - change) > 0.1)
            return step;
        change = now;
    }
    return 1;
}

struct Numbers {
    QStringList guesses{};
    Print repairs{};
    Print values{};
    Print origins{};
};

/// What may be at fault at \p step.
void addMoment(const Task &task, const ProgramLines &program, qint64 step, Numbers &to)
{
    const Submission submission(task.preset, program.source());
    const Moment moment{
        .stage = {task.preset, false}, .step = step, .circles = {0}, .isPosition = step % 2 == 1};
    const RanLines ran = ranLines(program.source(), moment);
    const int last = lastAssignmentLine(submission, moment.stage, step, 0);
    const PushOrigin pushes(program, ran);
    const ValueOrigin values(program.source(), task.solution, moment, ran, step > 1);
    for (const int line : ran.now) {
        to.origins << line << pushes.ofGiven(line, {last}).value_or(-1) << pushes.ofAdded(line)
                   << values.isWriteBack(line) << values.of(line);
    }
    to.origins << ran.now << ran.before << ran.special() << last
               << HitAtMoment(program.source(), task.solution, moment).isSizeWrong();
    const HitAtMoment hit(program.source(), task.solution, moment);
    QStringList guesses;
    for (const Aspect aspect : aspects) {
        for (const Suspect suspect : suspects) {
            for (const Topic topic : {Topic::Other, Topic::Direction, Topic::Restitution}) {
                if (topic != Topic::Other && aspect != Aspect::Response)
                    continue;
                const LawDeviation deviation{
                    .aspect = aspect, .moment = moment, .suspect = suspect, .topic = topic};
                const int line =
                    guessedLine(program.source(), deviation, ran,
                                {.line = last,
                                 .origin = values.isWriteBack(last) ? std::optional(values.of(last))
                                                                    : std::nullopt,
                                 .hit = [&] { return hit; }});
                guesses.append(QString::number(line));
            }
        }
    }
    to.guesses.append(guesses.join(QLatin1Char(' ')));
}

/// The changes of whole values.
void addValues(const Task &task, const QString &source, const std::vector<int> &all, qint64 step,
               Print &to)
{
    const Moment moment{.stage = {task.preset, false}, .step = step, .circles = {0}};
    const RanLines ran = ranLines(source, moment);
    SoundValues sound(source, moment);
    for (const auto &[aspect, suspect] : approved::valued) {
        to << soundLines(sound, all, aspect, suspect);
        for (const ValueChange change : {ValueChange::Completed, ValueChange::Replaced})
            to << valueRepairsOf(sound, all, aspect, suspect, ran.now, change);
    }
}

/// \param isWhole  with what takes longer
QString told(const Task &task, const QString &source, bool isWhole)
{
    const ProgramLines program(source);
    std::vector<int> all;
    for (int line = 1; line <= program.count(); ++line)
        all.push_back(line);
    Numbers numbers;
    std::vector<Repair> repairs = repairsOf(source, task.solution, all, 100'000);
    const std::size_t count = repairs.size();
    numbers.repairs << repairs;
    putInOrder(repairs, source, {1, 5, 9, 13}, false);
    numbers.repairs << repairs;
    QString text = QStringLiteral("statements %1, lines %2, quantities %3, %4 repairs %5\n")
                       .arg(approved::statements(program), approved::lines(program),
                            approved::quantities(program))
                       .arg(count)
                       .arg(numbers.repairs.text());
    if (!isWhole)
        return text;
    const qint64 turn = firstTurn(source, {task.preset, false});
    addMoment(task, program, 1, numbers);
    addMoment(task, program, turn, numbers);
    addValues(task, source, all, turn, numbers.values);
    return text
           + QStringLiteral("  values %1, origins %2\n  %3\n")
                 .arg(numbers.values.text(), numbers.origins.text(),
                      numbers.guesses.join(QStringLiteral("\n  ")));
}

} // namespace

void TestApprovedChanges::changesAreAsApproved()
{
    QFETCH(Task, task);
    QString all;
    int count = 0;
    int diffs = 0;
    for (const approved::Program &program : approved::programsOf(task.id)) {
        // Those with something wrong in them are like the one that is right.
        if (program.name.contains(QLatin1String(".diff")) && ++diffs % 5 != 0)
            continue;
        if (!findSyntaxError(program.source))
            all += program.name + QLatin1Char(' ') + told(task, program.source, ++count % 8 == 1);
    }
    const QString difference =
        approved::compare(QStringLiteral("changes/%1.txt").arg(task.id), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedChanges)
#include "test_approved_changes.moc"
