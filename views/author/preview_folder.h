// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

#include <QTemporaryDir>

#include <memory>

namespace cradle {

/// The pictures of a step as files, so that a text can be shown with them before it is saved. They
/// lie in a temporary folder from the first picture on; those of windows that were killed go then.
class PreviewFolder
{
public:
    /// Writes those pictures of \p step that changed. \return the folder with them; empty if the
    /// step has none
    QString follow(const LabFiles &files, const QString &step);

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QMap<QString, QByteArray> m_written; ///< by file name
    QString m_step;
    int m_count = 0; ///< of steps shown
};

} // namespace cradle
