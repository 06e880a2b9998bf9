// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"

#include "app/lab_drop.h"
#include "app/notice_bar.h"
#include "tasks/authoring/lab_archive.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/figure.h"
#include "views/author/lab_dialog.h"
#include "views/author/scene_tab.h"
#include "views/author/text_tab.h"
#include "views/scene/scene_view.h"
#include "views/theme.h"

#include <QDir>
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

/// A name for a file or an id made of \p title: letters, digits and dashes.
QString nameFrom(const QString &title)
{
    QString name;
    for (const QChar letter : title.toLower()) {
        const bool plain = letter.unicode() < 128 && letter.isLetterOrNumber();
        if (plain)
            name.append(letter);
        else if (!name.isEmpty() && !name.endsWith(QLatin1Char('-')))
            name.append(QLatin1Char('-'));
    }
    while (name.endsWith(QLatin1Char('-')))
        name.chop(1);
    return name.isEmpty() ? QStringLiteral("lab") : name.left(64);
}

bool isEmptyFolder(const QString &path)
{
    return QFileInfo(path).isDir()
           && QDir(path).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden);
}

/// Asks for a folder that a lab may be written into: a new one, or one in which nothing is, which
/// a QFileDialog for saving would open instead of taking it.
class NewFolderDialog final : public QFileDialog
{
public:
    NewFolderDialog(QWidget *parent, const QString &title)
        : QFileDialog(parent, title)
    {
        setFileMode(QFileDialog::AnyFile);
        setAcceptMode(QFileDialog::AcceptSave);
        setOption(QFileDialog::ShowDirsOnly);
        // Nothing is overwritten: a folder in which something is will be refused.
        setOption(QFileDialog::DontConfirmOverwrite);
        setOption(QFileDialog::DontUseNativeDialog);
    }

    /// The one that was chosen.
    [[nodiscard]] QString folder() const
    {
        return isEmptyFolder(typed()) ? typed() : selectedFiles().value(0);
    }

protected:
    void accept() override
    {
        if (isEmptyFolder(typed()))
            QDialog::accept();
        else
            QFileDialog::accept();
    }

private:
    /// Completion selects what exists, so that selectedFiles() names every folder on the way.
    [[nodiscard]] QString typed() const
    {
        const auto *name = findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
        return name && !name->text().isEmpty()
                   ? QDir::cleanPath(directory().absoluteFilePath(name->text()))
                   : QString();
    }
};

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
    const Result<QString> folder = labFolder(path);
    if (!folder)
        report(folder.error());
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
    if (!error)
        return true;
    if (overwrite || changedOnDisk(m_document.onDisk(), m_document.folder()).isEmpty()) {
        report(*error);
        return false;
    }
    QMessageBox box(QMessageBox::Warning, tr("Changed by another program"), error->message,
                    QMessageBox::Cancel, this);
    QPushButton *replace = box.addButton(tr("Replace with mine"), QMessageBox::DestructiveRole);
    QPushButton *reload = box.addButton(tr("Take theirs"), QMessageBox::DestructiveRole);
    box.exec();
    if (box.clickedButton() == replace)
        return saveInto(true);
    if (box.clickedButton() == reload) {
        if (const auto unread = m_document.reload())
            report(*unread);
    }
    return false;
}

bool AuthorWindow::saveAs()
{
    NewFolderDialog dialog(this, tr("A new or empty folder for the lab"));
    dialog.setLabelText(QFileDialog::FileName, tr("Folder:"));
    dialog.selectFile(nameFrom(m_document.lab().title));
    if (dialog.exec() != QDialog::Accepted)
        return false;
    if (const auto error = m_document.saveAs(dialog.folder())) {
        report(*error);
        return false;
    }
    m_notice->clearNotice();
    m_offer = Offer::None;
    return true;
}

void AuthorWindow::exportLab()
{
    QString path = QFileDialog::getSaveFileName(
        this, tr("Export the lab as one file"),
        nameFrom(m_document.lab().title) + QLatin1String(archiveSuffix),
        tr("Labs (*.cradle);;All files (*)"), nullptr, QFileDialog::DontUseNativeDialog);
    if (path.isEmpty())
        return;
    if (!isLabArchive(path) && QFileInfo(path).suffix().isEmpty())
        path += QLatin1String(archiveSuffix);
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
        LabDialog(m_document, this).exec();
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

bool AuthorWindow::mayDiscard()
{
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
