// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

class KeepingDesk;
class NoticeBar;
class Workbench;

/// Opens what can be made of work that is kept: reports, what is handed in, grades.
class WorkDialogs final : public QObject
{
    Q_OBJECT
public:
    /// \param keeping  has the newest notes
    /// \param window   the dialogs lie over it
    WorkDialogs(Workbench &workbench, KeepingDesk &keeping, NoticeBar &notice, QWidget &window);

public slots:
    void openReport(); ///< looks back at the work so far, from where a report is written
    void openHandIn();
    void openGrading(); ///< of a class, by the open lab
    void shareWork();   ///< with a git repository elsewhere

private:
    void lookBack(bool finished);
    [[nodiscard]] bool hasWork();

    Workbench &m_workbench;
    KeepingDesk &m_keeping;
    NoticeBar &m_notice;
    QWidget &m_window;
};

} // namespace cradle
