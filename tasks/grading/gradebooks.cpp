// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/gradebooks.h"

#include "model/files/file_io.h"
#include "tasks/grading/csv_text.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct GradebookText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

/// The parts of a name as platforms sort it: "Lovelace, Ada" and "Ada Lovelace" alike. Only for
/// reading; nothing is found by it.
std::pair<QString, QString> lastAndFirst(const QString &name)
{
    if (const auto comma = name.indexOf(QLatin1Char(',')); comma > 0)
        return {name.left(comma).trimmed(), name.mid(comma + 1).trimmed()};
    const QString whole = name.trimmed();
    const auto space = whole.lastIndexOf(QLatin1Char(' '));
    return {whole.mid(space + 1), whole.left(std::max<qsizetype>(space, 0))};
}

QString sumText(const Points &points)
{
    return points.earned ? pointsText(*points.earned) : QString();
}

} // namespace

Gradebooks::Gradebooks(const Lab &lab, const ClassFacts &facts)
    : m_lab(lab)
    , m_facts(facts)
{
    QStringList plain{QStringLiteral("id"),
                      QStringLiteral("name"),
                      QStringLiteral("number"),
                      QStringLiteral("email"),
                      QStringLiteral("handed_in"),
                      QStringLiteral("steps_passed"),
                      QStringLiteral("steps_not_graded"),
                      QStringLiteral("late_days"),
                      QStringLiteral("points"),
                      QStringLiteral("max_points")};
    for (const Task &task : lab.tasks) {
        m_most += mostPoints(task);
        plain.append(task.id);
    }
    m_plain = byteOrderMark + csvRow(plain);
    m_moodle = byteOrderMark
               + csvRow({QStringLiteral("Identifier"), QStringLiteral("Full name"),
                         QStringLiteral("ID number"), QStringLiteral("Email address"), lab.title,
                         QStringLiteral("%1 (Feedback)").arg(lab.title)});
    const QString most = pointsText(m_most);
    m_canvas =
        byteOrderMark
        + csvRow({QStringLiteral("Student"), QStringLiteral("ID"), QStringLiteral("SIS User ID"),
                  QStringLiteral("SIS Login ID"), QStringLiteral("Section"), lab.title})
        + csvRow({QStringLiteral("    Points Possible"), {}, {}, {}, {}, most});
    // No mark: nobody outside knows whether Blackboard reads quotes that come behind one.
    m_blackboard = csvRow({QStringLiteral("Last Name"), QStringLiteral("First Name"),
                           QStringLiteral("Username"), QStringLiteral("Student ID"),
                           QStringLiteral("%1 [Total Pts: %2 Score]").arg(lab.title, most)},
                          true);
}

void Gradebooks::addTo(const Person &person, const QString &sum, const QString &word)
{
    // A number means a person only where it was given out: Canvas would look up another's ID.
    const auto numberIf = [&](Platform platform) {
        return person.platform == platform ? person.number : QString();
    };
    const QString ofUniversity = numberIf(Platform::None);
    const QString name = person.name.isEmpty() ? person.id : person.name;
    const QString moodle = numberIf(Platform::Moodle);
    m_moodle += csvRow({moodle.isEmpty() ? QString() : QStringLiteral("Participant ") + moodle,
                        name, ofUniversity, person.email, sum, word});
    m_canvas += csvRow(
        {name, numberIf(Platform::Canvas), ofUniversity, person.email, m_facts.className, sum});
    const auto [last, first] = lastAndFirst(name);
    const QString account = numberIf(Platform::Blackboard);
    m_blackboard +=
        csvRow({last, first, account.isEmpty() ? person.id : account, ofUniversity, sum}, true);
}

void Gradebooks::add(const StudentResult &student)
{
    int passed = 0;
    int notGraded = 0;
    QStringList steps;
    for (const Task &task : m_lab.tasks) {
        const StepResult &step = resultOf(student, task);
        passed += step.status == StepResult::Status::Passed;
        notGraded += step.status == StepResult::Status::NotGraded;
        steps.append(sumText(pointsOf(step, task)));
    }
    const QString sum = sumText(pointsOf(student, m_lab, m_facts.late));
    m_plain += csvRow(QStringList{student.id, student.name, student.number, student.email,
                                  QStringLiteral("yes"), QString::number(passed),
                                  QString::number(notGraded), pointsText(student.lateDays), sum,
                                  pointsText(m_most)}
                      + steps);
    QString word = GradebookText::tr("%1 of %2 steps pass").arg(passed).arg(m_lab.tasks.size());
    if (notGraded > 0)
        word += QStringLiteral("; ") + GradebookText::tr("%1 not graded").arg(notGraded);
    addTo({student.id, student.name, student.number, student.email, student.platform}, sum, word);
}

std::optional<Error> Gradebooks::write(const QString &folder)
{
    const QString none = pointsText(0.0);
    for (const MissingStudent &student : m_facts.missing) {
        QStringList row{
            student.id, student.name, student.number, student.email, QStringLiteral("no"),
            none,       none,         none,           none,          pointsText(m_most)};
        for (std::size_t i = 0; i < m_lab.tasks.size(); ++i)
            row.append(none);
        m_plain += csvRow(row);
        addTo({student.id, student.name, student.number, student.email}, none,
              GradebookText::tr("Nothing was handed in"));
    }
    const QString below = folder + QStringLiteral("/gradebooks");
    if (auto error = makeFolder(below))
        return error;
    const std::pair<QString, const QByteArray &> files[] = {
        {folder + QStringLiteral("/gradebook.csv"), m_plain},
        {below + QStringLiteral("/moodle.csv"), m_moodle},
        {below + QStringLiteral("/canvas.csv"), m_canvas},
        {below + QStringLiteral("/blackboard.csv"), m_blackboard}};
    for (const auto &[path, text] : files) {
        if (auto error = writeFile(path, text))
            return error;
    }
    return std::nullopt;
}

} // namespace cradle
