// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/code_session.h"
#include "app/lab_place.h"
#include "tasks/questions/answers.h"
#include "tasks/workspace/progress.h"

#include <QTimer>

namespace cradle {

/// How far the student has come in the open lab: what was passed, the hints, predictions, answers
/// and scenes. It is kept between starts; what was said lies beside the programs, too, where it is
/// handed in with them.
class KeptProgress final : public QObject
{
    Q_OBJECT
public:
    /// \param place  outlives this, as does \p code
    /// \param file   where the progress is kept; empty: nowhere
    KeptProgress(const LabPlace &place, CodeSession &code, const QString &file);

    /// Keeps the progress in \p file from now on. \return what was wrong with it
    std::optional<Error> open(const QString &file);
    /// Reads the file once more: another window wrote it.
    std::optional<Error> readAgain() { return m_store.load(); }
    /// Takes scenes and predictions as the open work has them, which came without a progress.
    void takeFromWork();

    /// Whether nothing has ever been done in the open lab.
    [[nodiscard]] bool isEmpty() { return ofLab().tasks.empty(); }
    [[nodiscard]] QString lastStep() { return ofLab().currentTask; } ///< where the student left off
    [[nodiscard]] bool isPassed(const Task &task) const;
    [[nodiscard]] std::vector<bool> passed() const; ///< one for each step

    // Of the open step; without one, nothing.
    [[nodiscard]] int hintsOpened();
    /// What the last check that the step passed has left; invalid if there is none.
    [[nodiscard]] Pass pass();
    [[nodiscard]] Guess guess(); ///< what the student expects
    [[nodiscard]] Answers answers() const;
    [[nodiscard]] std::optional<Preset> scene(); ///< what the student has made of the step's
    /// Whether the reference program may be seen: after passing, or after all hints.
    [[nodiscard]] bool mayShowSolution();

public slots:
    void setHintsOpened(int count);
    void predict(int answer); ///< or Guess::notSure
    void revealOutcome();     ///< shows what the prediction was about
    void answer(const QString &question, const QJsonValue &value);
    void noteOpened(); ///< the step is where the student left off
    void noteScene(const std::optional<cradle::Preset> &scene);
    void notePassed(const cradle::Pass &pass);
    void noteWatched(); ///< the scene has moved: a question that waits for that says so
    void save();        ///< and the program, now
    void saveDue();     ///< the same, if something waits to be saved

signals:
    void hintsChanged();
    void guessChanged();
    void answersChanged();
    void failed(const cradle::Error &error); ///< could not be saved

private:
    [[nodiscard]] LabProgress &ofLab() { return m_store.lab(m_place.lab.id); }
    TaskProgress &ofStep();
    void keepSaid();

    const LabPlace &m_place;
    CodeSession &m_code;
    ProgressStore m_store;
    QTimer m_saveSoon;
};

} // namespace cradle
