// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_programs.h"

#include "tasks/judging/asked_values.h"
#include "tasks/judging/last_assignment.h"
#include "tasks/judging/line_guess.h"
#include "tasks/judging/program_rows.h"
#include "tasks/judging/push_origin.h"
#include "tasks/judging/quantities.h"
#include "tasks/judging/repair_order.h"
#include "tasks/judging/value_origin.h"
#include "tasks/judging/value_repairs.h"

#include <QCryptographicHash>

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
/// What is tried for values, which takes longest.
constexpr std::pair<Aspect, Suspect> valued[] = {{Aspect::Motion, Suspect::Answer},
                                                 {Aspect::Walls, Suspect::Reach},
                                                 {Aspect::Contact, Suspect::Reach},
                                                 {Aspect::Response, Suspect::Answer},
                                                 {Aspect::Response, Suspect::Masses}};
constexpr Suspect suspects[] = {Suspect::Answer, Suspect::Formula, Suspect::Question,
                                Suspect::Reach,  Suspect::Masses,  Suspect::Copy,
                                Suspect::Kept,   Suspect::Omission};

/// A hash of texts and numbers, in turn.
class Print
{
public:
    Print &operator<<(const QString &text)
    {
        m_hash.addData(text.toUtf8() + '\n');
        return *this;
    }
    Print &operator<<(const QStringList &all) { return *this << all.join(QLatin1Char('\t')); }
    template <typename Number>
    Print &operator<<(Number number) requires std::is_arithmetic_v<Number>
    {
        return *this << QString::number(number);
    }
    template <typename Numbers>
    Print &operator<<(const Numbers &all) requires std::is_integral_v<typename Numbers::value_type>
    {
        for (const auto each : all)
            *this << each;
        return *this << QStringLiteral(".");
    }
    Print &operator<<(const NamedCircle &c)
    {
        return *this << c.position << c.velocity << c.radius << c.density;
    }
    Print &operator<<(const std::vector<Repair> &all)
    {
        for (const Repair &each : all)
            *this << each.source << each.line << each.alone << each.told;
        return *this << all.size();
    }
    [[nodiscard]] QString text() const
    {
        return QString::fromLatin1(m_hash.result().toHex().left(12));
    }

private:
    QCryptographicHash m_hash{QCryptographicHash::Sha256};
};

QString statements(const ProgramLines &program)
{
    Print print;
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    print << program.timesteps() << deadLines(program)
          << copiesOf(program, assignments, {QStringLiteral("radius"), QStringLiteral("density")});
    for (const ProgramAssignment &each : assignments)
        print << each.line << each.name << each.isField << each.target << each.from << each.to
              << each.last << valuesIn(program, each.from, each.to) << isHandedOn(program, each);
    const std::vector<ProgramFunction> functions = functionsOf(program);
    for (const ProgramFunction &each : functions)
        print << each.name << each.parameters << each.first << each.last;
    for (std::size_t i = 0; i < program.tokens().size(); ++i)
        print << program.afterOperand(i) << afterExpression(program, i) << program.isNewName(i);
    for (int line = 1; line <= program.count(); ++line)
        print << (functionAt(functions, line) ? functionAt(functions, line)->first : 0);
    return print.text();
}

QString lines(const ProgramLines &program)
{
    Print print;
    const QStringList rows = rowsOf(program.source());
    const AskedValues asked(program);
    for (int line = 1; line <= program.count(); ++line) {
        const QString &row = rows[line - 1];
        const RowRange range = functionOf(rows, line);
        print << program.bodiesNear(line) << program.forgotten(line) << program.isCall(line) << row
              << compares(row) << worksOut(row) << asksForWall(row) << range.first << range.last;
        for (const int twin : program.twinsOf(line))
            print << twin << program.inTwin(row, line, twin)
                  << program.placeIn(line, twin, row.size() / 2).value_or(-1);
        for (const AskedValue &value : asked.of(line))
            print << value.line << value.isReach;
        print << asked.asksReach(line) << asked.valueBehind(line, true)
              << asked.valueBehind(line, false) << asked.isJoined(line);
    }
    return print.text();
}

QString quantities(const ProgramLines &program)
{
    Print print;
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    const std::vector<ProgramFunction> functions = functionsOf(program);
    for (int line = 1; line <= program.count(); line += 5) {
        const NamesAtHand names(program, assignments, functions, line);
        for (const NamedCircle &circle : names.circles())
            print << circle;
        if (const auto pair = names.pair())
            print << pair->first << pair->second;
        print << names.radii() << names.normals() << names.ofRadius() << names.parameters()
              << names.masses();
        for (const auto &[aspect, suspect] : valued) {
            const Quantities all(names, program.timesteps(), aspect, suspect);
            print << all.all() << all.sound() << all.parts() << all.sides(QStringLiteral("d"))
                  << all.completed(QStringLiteral("v"), program.forgotten(line));
        }
    }
    return print.text();
}

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
               << PushOrigin::isSizeWrong(program.source(), task.solution, moment);
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
                                 .isSizeWrong = [] { return true; }});
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
    for (const auto &[aspect, suspect] : valued) {
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
    putInOrder(repairs, source, {1, 5, 9, 13});
    numbers.repairs << repairs;
    QString text = QStringLiteral("statements %1, lines %2, quantities %3, %4 repairs %5\n")
                       .arg(statements(program), lines(program), quantities(program))
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
