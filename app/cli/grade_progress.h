// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_grader.h"

#include <QElapsedTimer>

namespace cradle::cli {

/// Tells how grading goes on: a bar on a terminal, else a line now and then, or for other programs
/// events as JSON, one a line.
class GradeProgress
{
public:
    enum class Form { Bar, Lines, Events };

    /// A bar if standard error is a terminal.
    explicit GradeProgress(bool events);

    void start(int students, const QString &isolation);
    void show(const ClassProgress &progress);
    void tell(const ClassProgress &progress, const StudentResult &student);
    /// Pages and tables are being written.
    void writing(int done, int total);
    /// The last word. \param outcome  "done", "stopped"
    void end(const ClassProgress &progress, const char *outcome);
    void remark(const QString &text);
    /// Why not all events could be written, if so.
    [[nodiscard]] const std::optional<Error> &fault() const { return m_fault; }

private:
    void event(const QJsonObject &json);
    void clearBar();
    void showBar(const QString &text, int done, int total);
    [[nodiscard]] QString textOf(const ClassProgress &progress) const;

    Form m_form;
    QElapsedTimer m_timer{};
    qint64 m_shown = -1'000'000; ///< ms
    bool m_barStands = false;
    std::optional<Error> m_fault{};
};

} // namespace cradle::cli
