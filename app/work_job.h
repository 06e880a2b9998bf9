// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/hand_in/hand_in.h"
#include "views/formula_setting.h"

#include <QFutureWatcher>
#include <QObject>

#include <memory>

namespace cradle {

/// Judges all of a student's work anew, off the GUI thread, and sets the formulas of its notes, for
/// a report or to be handed in.
class WorkJob final : public QObject
{
    Q_OBJECT
public:
    explicit WorkJob(QObject *parent = nullptr);
    ~WorkJob() override;

    /// \param folder  of the workspace
    void start(const Lab &lab, const QString &folder, const Sender &sender);
    void cancel(); ///< finished() does not follow

signals:
    void progressed(int done, int total);
    void finished(const cradle::HandIn &handIn);
    void failed(const cradle::Error &error);

private:
    FormulaSetting m_setting;
    QFutureWatcher<std::shared_ptr<const Result<HandIn>>> m_watcher;
    std::shared_ptr<std::atomic_bool> m_stop;
};

/// Why nothing is judged: what lies on the disk, and would be, is older than what was typed.
[[nodiscard]] QString unsavedText();

} // namespace cradle
