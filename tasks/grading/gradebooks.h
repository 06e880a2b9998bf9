// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_results.h"

namespace cradle {

/// The points of a class as tables that learning platforms import, gathered student by student.
/// Where a step has no verdict, its cell and the sum stay empty: importing an empty cell changes no
/// grade. Points are rounded to the hundredth, halves up, after lateness. All but Blackboard's
/// begin with a byte order mark, without which Excel misreads names.
class Gradebooks
{
public:
    /// Both must outlive this.
    Gradebooks(const Lab &lab, const ClassFacts &facts);

    void add(const StudentResult &student);

    /// gradebook.csv (all that is known, for people and programs), and gradebooks/moodle.csv,
    /// canvas.csv and blackboard.csv below \p folder. Those of the roster who handed in nothing are
    /// in them with no points.
    [[nodiscard]] std::optional<Error> write(const QString &folder);

private:
    struct Person {
        QString id{};
        QString name{};
        QString number{};
        QString email{};
        Platform platform = Platform::None;
    };
    void addTo(const Person &person, const QString &sum, const QString &word);

    const Lab &m_lab;
    const ClassFacts &m_facts;
    double m_most = 0.0; ///< points
    QByteArray m_plain{};
    QByteArray m_moodle{};
    QByteArray m_canvas{};
    QByteArray m_blackboard{};
};

} // namespace cradle
