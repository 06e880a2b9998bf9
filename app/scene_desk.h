// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/student_script.h"

#include <QObject>

#include <optional>

namespace cradle {

class Workbench;
struct Panes;

/// Joins the scene to the panes that tell of its moments.
class SceneDesk final : public QObject
{
    Q_OBJECT
public:
    SceneDesk(Workbench &workbench, Panes &panes);

    void showGhost(); ///< what runs beside the student's circles, in the language in force

private:
    void wireValues();
    void showPause(const cradle::StudentScript::Pause &pause);
    void showVisit(bool visiting);

    Workbench &m_workbench;
    Panes &m_panes;
    std::optional<bool> m_saidFault; ///< of a scene of a check, that this is the moment
};

} // namespace cradle
