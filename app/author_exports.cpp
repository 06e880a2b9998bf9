// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_exports.h"

#include "app/author_notices.h"
#include "app/new_folder_dialog.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/student_edition.h"
#include "tasks/reading/lab_archive.h"
#include "views/author/author_document.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace cradle {

namespace {

constexpr int mostFaults = 8; ///< that a question tells

} // namespace

AuthorExports::AuthorExports(AuthorDocument &document, AuthorNotices &notices, QWidget &window)
    : m_document(document)
    , m_notices(notices)
    , m_window(window)
{
}

/// Who exports a lab of which something cannot be read should know that.
bool AuthorExports::mayExport()
{
    m_document.readNow();
    QStringList faults;
    for (const std::vector<Error> *list : {&m_document.unread(), &m_document.lab().findings}) {
        for (const Error &fault : *list)
            faults.append(fault.toString());
    }
    if (faults.isEmpty())
        return true;
    QMessageBox box(QMessageBox::Warning, tr("Not all of it can be read"),
                    tr("Students will not find what cannot be read:") + QStringLiteral("\n\n")
                        + QStringList(faults.mid(0, mostFaults)).join(QLatin1Char('\n')),
                    QMessageBox::Cancel, &m_window);
    box.setTextFormat(Qt::PlainText);
    QPushButton *go = box.addButton(tr("Export anyway"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == go;
}

QString AuthorExports::exportTo(const LabFiles &files, const QString &title, const QString &name)
{
    QString path = QFileDialog::getSaveFileName(
        &m_window, title, name + QLatin1String(archiveSuffix), tr("Labs (*.cradle);;All files (*)"),
        nullptr, QFileDialog::DontUseNativeDialog);
    if (path.isEmpty())
        return {};
    if (!isLabArchive(path) && QFileInfo(path).suffix().isEmpty())
        path += QLatin1String(archiveSuffix);
    const auto error = cradle::exportLab(files, path);
    if (error)
        m_notices.report(*error);
    return error ? QString() : path;
}

/// What students are to find for themselves stays here; what that costs them is said.
void AuthorExports::exportForStudents()
{
    if (!mayExport())
        return;
    const Result<StudentEdition> edition = studentEdition(m_document.files());
    if (!edition) {
        m_notices.report(edition.error());
        return;
    }
    const QString path = exportTo(edition->files, tr("Export the lab for students"),
                                  nameFrom(m_document.lab().title) + QStringLiteral("-students"));
    if (path.isEmpty())
        return;
    QString said =
        tr("Exported without %n file(s) that are yours: %1", nullptr, edition->left).arg(path);
    if (!edition->unexplained.isEmpty())
        said += QStringLiteral(". ")
                + tr("In %1 students are told what checks saw, and not which law is wrong.")
                      .arg(edition->unexplained.join(QStringLiteral(", ")));
    m_notices.say(said);
}

void AuthorExports::exportLab()
{
    if (!mayExport())
        return;
    const QString path = exportTo(m_document.files(), tr("Export the lab as one file"),
                                  nameFrom(m_document.lab().title));
    if (!path.isEmpty())
        m_notices.say(tr("Exported: %1").arg(path));
}

} // namespace cradle
