// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProcess>
#include <QStringList>

namespace cradle {

/// What `cradle-cli grade` is asked to do.
struct GradeOrder {
    QString submissions{}; ///< a folder, or a zip
    QString lab{};         ///< the lab's folder
    QString results{};     ///< a folder
    QString roster{};      ///< a CSV file; empty: none
    double latePercent = 0.0;
    QString language = QStringLiteral("en"); ///< of pages and verdicts
    bool again = false; ///< begins anew where there are results of another version

    [[nodiscard]] QStringList arguments() const;
};

/// How far a class is.
struct GradeState {
    int students = 0;
    int done = 0;
    int kept = 0; ///< of them, as they were from a run before
    int passed = 0;
    int failed = 0; ///< steps, as passed and notGraded
    int notGraded = 0;
};

/// Runs `cradle-cli grade` beside this program, and reads its events. It does no more than the
/// command does, and what it has written goes on where it was when it is run again.
class GradeRun final : public QObject
{
    Q_OBJECT
public:
    explicit GradeRun(QObject *parent = nullptr);
    /// Ends the command; what is judged stays.
    ~GradeRun() override;

    void start(const GradeOrder &order);
    void stop(); ///< asks it to end; ended() follows
    [[nodiscard]] bool isRunning() const { return m_process.state() != QProcess::NotRunning; }
    [[nodiscard]] const GradeState &state() const { return m_state; }

    /// Where the command lies; beside this program unless said otherwise.
    void setProgram(const QString &path) { m_path = path; }

signals:
    void progressed(const cradle::GradeState &state);
    void remarked(const QString &text);
    /// \param complete  all are judged and all is written
    /// \param fault     why not, in the words of the command; empty if it was stopped
    void ended(bool complete, const QString &fault);

private:
    void readEvents();
    void take(const QByteArray &line);
    void finish(int code, bool crashed);

    QProcess m_process;
    QString m_path;
    GradeState m_state{};
    bool m_complete = false;
};

} // namespace cradle
