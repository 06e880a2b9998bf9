// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_results.h"
#include "tasks/grading/similar_programs.h"

#include <map>

namespace cradle {

/// What is known of a class once every student was added; of students no more is kept than a page
/// shows, so that thousands fit into memory.
class ClassSummary
{
public:
    /// A student in the table of who is where.
    struct Row {
        QString id{};
        QString name{};
        std::vector<StepResult::Status> steps{}; ///< in the lab's order
        Points points{};                         ///< after lateness
        int passed = 0;
    };
    /// Something that was found wrong in a step, and who met it first, without a name.
    struct Misunderstanding {
        Aspect aspect = Aspect::Motion;
        QString headline{}; ///< plain text
        QString message{};  ///< below the headline; CommonMark
        QString code{};     ///< some lines of the program around the line, without comments
        int codeLine = 0;   ///< the marked one of them, from 1; 0 if there is none
        int count = 0;      ///< students
    };
    struct Check {
        QString id{};
        QString title{};
        int passed = 0;
        int failed = 0; ///< not met, and judged
    };
    struct Step {
        QString id{};
        QString title{};
        int passed = 0;
        int failed = 0;
        int missing = 0;
        int notGraded = 0;
        int stopped = 0;                 ///< of the failed: a program that does not load, or stops
        std::map<Aspect, int> aspects{}; ///< students with a finding of that sort
        std::map<QString, Misunderstanding> misunderstandings{}; ///< by the mistake's name
        std::vector<Check> checks{};                             ///< in the lab's order
        std::vector<int> attempts{};   ///< of those whose history tells them
        std::vector<double> minutes{}; ///< the same, and of those whose history tells no checks
    };
    struct Alike {
        QString first{}; ///< names
        QString second{};
        int shared = 0;
        double part = 0.0;
        QString firstTask{}; ///< in whose programs they share most
        QString secondTask{};
        QString firstCode{}; ///< the lines that they share, with their numbers
        QString secondCode{};
    };
    /// A step of a student without a verdict.
    struct NotGraded {
        QString name{};
        QString taskId{};
        QString reason{};
    };

    /// What was handed in has another number than the roster; the roster's was taken.
    struct OtherNumber {
        QString name{};
        QString drawnBy{};
        QString handedIn{};
    };

    ClassSummary(const Lab &lab, const ClassFacts &facts);

    void add(const StudentResult &student);

    /// Ends the gathering: who is alike. \param read  reads a student's result again, by index
    [[nodiscard]] std::optional<Error>
    finish(const std::function<Result<StudentResult>(int)> &read);

    [[nodiscard]] const std::vector<Row> &rows() const { return m_rows; }
    [[nodiscard]] const std::vector<Step> &steps() const { return m_steps; }
    [[nodiscard]] const std::vector<Alike> &alike() const { return m_alike; }
    [[nodiscard]] const std::vector<NotGraded> &notGraded() const { return m_notGraded; }
    [[nodiscard]] const std::vector<OtherNumber> &otherNumbers() const { return m_otherNumbers; }
    /// Who handed in each number, by plainNumber(); names.
    [[nodiscard]] const std::map<QString, QStringList> &handedNumbers() const
    {
        return m_handedNumbers;
    }
    [[nodiscard]] int commonFrom() const { return m_similar.commonFrom(); }

private:
    void addNumber(const QString &name, const StudentResult &student);
    void addStep(Step &sum, const StudentResult &student, const StepResult &step);

    const Lab &m_lab;
    const ClassFacts &m_facts;
    std::vector<Row> m_rows{};
    std::vector<Step> m_steps{};
    std::vector<Alike> m_alike{};
    std::vector<NotGraded> m_notGraded{};
    std::vector<OtherNumber> m_otherNumbers{};
    std::map<QString, QStringList> m_handedNumbers{};
    SimilarPrograms m_similar;
};

/// \p text without what tells whose it is: every word of the student's name, id, number and
/// address becomes "…".
[[nodiscard]] QString withoutNames(const QString &text, const StudentResult &student);

/// A program with every comment blanked out; its lines stay.
[[nodiscard]] QString withoutComments(const QString &program);

} // namespace cradle
