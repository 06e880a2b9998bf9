// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QObject>

class QSettings;
QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

class NoticeBar;
class Workbench;

/// Says what there is to know about the student's files, with what can be done about it.
class WorkNotices final : public QObject
{
    Q_OBJECT
public:
    /// \param window    what asks lies over it
    /// \param settings  know whether the name was asked for
    WorkNotices(Workbench &workbench, NoticeBar &notice, QSettings &settings, QWidget &window);

    /// Asks whether a program that cannot be saved is to be given up.
    [[nodiscard]] bool mayClose();

signals:
    void tourRequested();

private:
    void showTaskNotice();
    void showHolder();
    void showSetAside(const QString &name, const QString &kept);
    void reportUnsaved(const Error &error);
    void askNumber();
    void askNameOnce();
    void giveName();

    Workbench &m_workbench;
    NoticeBar &m_notice;
    QSettings &m_settings;
    QWidget &m_window;
    QString m_unsavedWarning; ///< that the program could not be saved
    QString m_taskNotice;     ///< what there was to say of the step, in this mode
};

} // namespace cradle
