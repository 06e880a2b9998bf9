// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"

#include "app/lab_drop.h"
#include "app/new_folder_dialog.h"
#include "app/notice_bar.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/student_edition.h"
#include "tasks/reading/lab_archive.h"
#include "views/author/checks_tab.h"
#include "views/author/difference_dialog.h"
#include "views/author/figure.h"
#include "views/author/lab_dialog.h"
#include "views/author/scene_tab.h"
#include "views/author/text_tab.h"
#include "views/scene/scene_view.h"
#include "views/theme.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace cradle {

// Dialogs of the window, and what they lead to.

namespace {

constexpr int mostFaults = 8; ///< that a question tells

} // namespace

void AuthorWindow::newLab()
{
    if (!mayDiscard())
        return;
    bool ok = false;
    const QString title = QInputDialog::getText(this, tr("New lab"), tr("Title of the lab:"),
                                                QLineEdit::Normal, tr("My lab"), &ok)
                              .trimmed();
    if (!ok || title.isEmpty())
        return;
    m_document.begin(cradle::newLab(nameFrom(title), title, m_document.language()));
}

void AuthorWindow::openLab()
{
    if (!mayDiscard())
        return;
    openPath(QFileDialog::getExistingDirectory(this, tr("Open a lab's folder")));
}

void AuthorWindow::openLabFile()
{
    if (mayDiscard())
        openPath(QFileDialog::getOpenFileName(this, tr("Open a lab in one file"), {},
                                              tr("Labs (*.cradle);;All files (*)")));
}

void AuthorWindow::openDropped(const QString &path)
{
    if (mayDiscard())
        openPath(path);
}

/// A folder, or one file; an empty path is none.
void AuthorWindow::openPath(const QString &path)
{
    if (path.isEmpty())
        return;
    const Result<QString> folder = labFolder(path, this);
    if (!folder)
        report(folder.error());
    else if (folder->isEmpty())
        return;
    else if (const auto error = open(*folder))
        report(*error);
}

bool AuthorWindow::save()
{
    if (m_document.folder().isEmpty() || m_document.isReadOnly())
        return saveAs();
    return saveInto(false);
}

bool AuthorWindow::saveInto(bool overwrite)
{
    const auto error = m_document.save(overwrite);
    if (!error) {
        tellRefused();
        return true;
    }
    if (overwrite || changedOnDisk(m_document.onDisk(), m_document.folder()).isEmpty()) {
        report(*error);
        return false;
    }
    const Result<LabFiles> theirs = readLabFiles(m_document.folder());
    if (!theirs) {
        report(theirs.error());
        return false;
    }
    // What they changed, and nothing of what only waits to be saved.
    const LabFiles merged = withTheirs(m_document.files(), m_document.onDisk(), *theirs);
    DifferenceDialog dialog(error->message, m_document.files(), merged, this);
    enum { ReplaceTheirs = 1, TakeTheirs };
    dialog.addChoice(tr("Replace with mine"), ReplaceTheirs);
    dialog.addChoice(tr("Take theirs"), TakeTheirs);
    const int choice = dialog.exec();
    if (choice == ReplaceTheirs)
        return saveInto(true);
    if (choice == TakeTheirs) {
        if (const auto unread = m_document.takeTheirs()) {
            report(*unread);
            return false;
        }
        m_notice->clearNotice(); // that something changed
        return saveInto(false);
    }
    return false;
}

/// Takes the folder's files. What is not saved would go with that, so it asks first.
void AuthorWindow::reload()
{
    const Result<LabFiles> theirs = readLabFiles(m_document.folder());
    if (m_document.isModified() && theirs && *theirs != m_document.files()) {
        DifferenceDialog dialog(tr("You have changes that are not saved. If you take the files of "
                                   "the folder instead, Undo brings yours back."),
                                m_document.files(), *theirs, this);
        dialog.addChoice(tr("Take theirs"), 1);
        if (dialog.exec() != 1) {
            offerReload(
                changedOnDisk(m_document.onDisk(), m_document.folder()).join(QStringLiteral(", ")));
            return;
        }
    }
    if (const auto error = m_document.reload())
        report(*error);
}

/// What is typed and is no value is not in the lab, and so not in what was saved.
void AuthorWindow::tellRefused()
{
    const QStringList fields = refused();
    if (!fields.isEmpty())
        m_notice->showNotice(tr("Saved, but for fields that hold no value yet: %1")
                                 .arg(fields.join(QStringLiteral(", "))));
}

bool AuthorWindow::saveAs()
{
    // What was never saved has no other copy yet.
    LabFiles files = m_document.files();
    if (!m_document.folder().isEmpty() && labForm(files)) {
        LabDialog naming(m_document, LabDialog::Purpose::Copy, this);
        if (naming.exec() != QDialog::Accepted)
            return false;
        files = naming.copy();
    }
    const Result<LabForm> lab = labForm(files);
    NewFolderDialog dialog(this, tr("A new or empty folder for the lab"));
    dialog.setLabelText(QFileDialog::FileName, tr("Folder:"));
    dialog.selectFile(nameFrom(lab ? lab->title : m_document.title()));
    if (dialog.exec() != QDialog::Accepted)
        return false;
    if (const auto error = m_document.saveCopy(dialog.folder(), files)) {
        report(*error);
        return false;
    }
    m_notice->clearNotice();
    m_offer = Offer::None;
    return true;
}

/// Who exports a lab of which something cannot be read should know that.
bool AuthorWindow::mayExport()
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
                    QMessageBox::Cancel, this);
    box.setTextFormat(Qt::PlainText);
    QPushButton *go = box.addButton(tr("Export anyway"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == go;
}

/// \return an empty path if none was chosen
QString AuthorWindow::askExportPath(const QString &title, const QString &name)
{
    QString path = QFileDialog::getSaveFileName(this, title, name + QLatin1String(archiveSuffix),
                                                tr("Labs (*.cradle);;All files (*)"), nullptr,
                                                QFileDialog::DontUseNativeDialog);
    if (!path.isEmpty() && !isLabArchive(path) && QFileInfo(path).suffix().isEmpty())
        path += QLatin1String(archiveSuffix);
    return path;
}

/// What students are to find for themselves stays here; what that costs them is said.
void AuthorWindow::exportForStudents()
{
    if (!mayExport())
        return;
    const Result<StudentEdition> edition = studentEdition(m_document.files());
    if (!edition) {
        report(edition.error());
        return;
    }
    const QString path =
        askExportPath(tr("Export the lab for students"),
                      nameFrom(m_document.lab().title) + QStringLiteral("-students"));
    if (path.isEmpty())
        return;
    if (const auto error = cradle::exportLab(edition->files, path)) {
        report(*error);
        return;
    }
    m_offer = Offer::None;
    QString said =
        tr("Exported without %n file(s) that are yours: %1", nullptr, edition->left).arg(path);
    if (!edition->unexplained.isEmpty())
        said += QStringLiteral(". ")
                + tr("In %1 students are told what checks saw, and not which law is wrong.")
                      .arg(edition->unexplained.join(QStringLiteral(", ")));
    m_notice->showNotice(said);
}

void AuthorWindow::exportLab()
{
    if (!mayExport())
        return;
    const QString path =
        askExportPath(tr("Export the lab as one file"), nameFrom(m_document.lab().title));
    if (path.isEmpty())
        return;
    if (const auto error = cradle::exportLab(m_document.files(), path)) {
        report(*error);
        return;
    }
    m_offer = Offer::None;
    m_notice->showNotice(tr("Exported: %1").arg(path));
}

void AuthorWindow::openAsStudent()
{
    if (m_document.isModified() && !save())
        return;
    m_document.readNow();
    const Task *task = m_document.task();
    emit studentRequested(m_document.folder(), task ? task->id : QString());
}

void AuthorWindow::editProperties()
{
    // A lab.json that cannot be read has no fields; the finding about it says why.
    if (const Result<LabForm> lab = labForm(m_document.files()); !lab)
        report(lab.error());
    else
        LabDialog(m_document, LabDialog::Purpose::Edit, this).exec();
}

void AuthorWindow::insertFigure()
{
    const QString step = m_document.step();
    if (step.isEmpty())
        return;
    const LabFiles &files = m_document.files();
    QString name;
    for (int number = 1; name.isEmpty() || files.contents.contains(step + QLatin1Char('/') + name);
         ++number)
        name = QStringLiteral("figure-%1.svg").arg(number);
    const QByteArray svg = figureOf(m_sceneTab->scene());
    if (!m_document.edit(tr("Insert a figure"),
                         withFile(files, step + QLatin1Char('/') + name, svg)))
        return;
    showTab(Text);
    m_textTab->insertFigure(
        name, tr("The scene at %1 s").arg(m_sceneTab->simulation().time(), 0, 'f', 2));
}

/// A window was killed, and this is what it had not saved.
void AuthorWindow::showDraft(const QDateTime &when)
{
    m_notice->warn(tr("Cradle ended without saving this lab. Your changes of %1 are back; they are "
                      "not saved yet.")
                       .arg(QLocale().toString(when.toLocalTime(), QLocale::ShortFormat)),
                   m_document.undoStack().canUndo()
                       ? std::vector<NoticeBar::Offer>{{tr("Discard them"),
                                                        [this] { m_document.undoStack().undo(); }}}
                       : std::vector<NoticeBar::Offer>());
}

void AuthorWindow::offerUnsavedLab()
{
    m_notice->warn(tr("Cradle ended before a new lab was saved for the first time."),
                   {{tr("Open it"), [this] {
                         if (mayDiscard())
                             m_document.openUnsavedDraft();
                     }}});
}

/// Fields and scenes of which something is typed that is no value, and so not in the lab.
QStringList AuthorWindow::refused() const
{
    return m_checksTab->refusedChecks() + m_textTab->refusedValues() + m_sceneTab->refusedScenes();
}

/// Saving does not keep what is no value: that goes with the window alone.
bool AuthorWindow::mayDropRefused()
{
    const QStringList fields = refused();
    if (fields.isEmpty())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Drop what was typed?"),
                    tr("What is typed here is no value yet, and is not in the lab: %1")
                        .arg(fields.join(QStringLiteral(", "))),
                    QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() == QMessageBox::Discard;
}

bool AuthorWindow::mayDiscard()
{
    if (!mayDropRefused())
        return false;
    if (!m_document.isModified())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Save the lab?"),
                    tr("The lab has changes that are not saved."),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        m_document.discardDraft();
        return true;
    default:
        return false;
    }
}

} // namespace cradle
