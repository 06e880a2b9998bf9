// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

#include <QObject>

QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

class AuthorDocument;
class AuthorNotices;

/// Writes the lab into one file, for other authors or for students.
class AuthorExports final : public QObject
{
    Q_OBJECT
public:
    /// All outlive this. \param window  dialogs lie over it
    AuthorExports(AuthorDocument &document, AuthorNotices &notices, QWidget &window);

public slots:
    void exportLab();
    void exportForStudents(); ///< the same without solutions and mistakes

private:
    /// Whether all of it can be read, or the author exports it anyway.
    bool mayExport();
    /// Writes \p files where the author wants them. \return the path; empty: nowhere
    QString exportTo(const LabFiles &files, const QString &title, const QString &name);

    AuthorDocument &m_document;
    AuthorNotices &m_notices;
    QWidget &m_window;
};

} // namespace cradle
