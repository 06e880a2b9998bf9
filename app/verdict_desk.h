// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace cradle {

class CodeDesk;
class Workbench;
struct Panes;

/// Joins the check of the work to the panes that tell its verdict.
class VerdictDesk final : public QObject
{
    Q_OBJECT
public:
    /// \param code  marks the line at fault
    VerdictDesk(Workbench &workbench, Panes &panes, CodeDesk &code);

private:
    void showReport();
    void announce();

    Workbench &m_workbench;
    Panes &m_panes;
    CodeDesk &m_code;
};

} // namespace cradle
