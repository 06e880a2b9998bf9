// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/examples.h"

#include <QObject>

QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

class NoticeBar;
class Workbench;

/// Opens labs, work and scenes that the student chooses, and says what is wrong with them.
class Opening final : public QObject
{
    Q_OBJECT
public:
    /// \param window  takes what is dropped on it; dialogs lie over it
    Opening(Workbench &workbench, NoticeBar &notice, QWidget &window);

public slots:
    void openLabFolder();
    void openLabFile(); ///< NAME.cradle
    /// Opens the lab in a folder, or unpacks one file into the user's labs and opens that.
    void openLab(const QString &path);
    void openPresetFile();
    void openExample(cradle::Example example);
    void savePresetAs();

private:
    Workbench &m_workbench;
    NoticeBar &m_notice;
    QWidget &m_window;
};

} // namespace cradle
