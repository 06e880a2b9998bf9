// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QObject>

QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

/// Takes labs that are dropped on a window, wherever on it: one local folder with a lab.json, or
/// one file NAME.cradle. An editor below the pointer would take their paths for text.
class LabDrop final : public QObject
{
    Q_OBJECT
public:
    /// \param window  owns this
    explicit LabDrop(QWidget *window);
    ~LabDrop() override;

signals:
    void dropped(const QString &path);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *m_window;
};

/// The folder of the lab at \p path: a file is unpacked to the user's labs first. Where another
/// version of it is there, \p asker asks which is to stay.
/// \return empty if that was cancelled
Result<QString> labFolder(const QString &path, QWidget *asker);

} // namespace cradle
