// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/new_folder_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QLineEdit>

namespace cradle {

namespace {

bool isEmptyFolder(const QString &path)
{
    return QFileInfo(path).isDir()
           && QDir(path).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden);
}

} // namespace

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

NewFolderDialog::NewFolderDialog(QWidget *parent, const QString &title)
    : QFileDialog(parent, title)
{
    setFileMode(QFileDialog::AnyFile);
    setAcceptMode(QFileDialog::AcceptSave);
    setOption(QFileDialog::ShowDirsOnly);
    // Nothing is overwritten: a folder in which something is will be refused.
    setOption(QFileDialog::DontConfirmOverwrite);
    setOption(QFileDialog::DontUseNativeDialog);
}

QString NewFolderDialog::folder() const
{
    return isEmptyFolder(typed()) ? typed() : selectedFiles().value(0);
}

void NewFolderDialog::accept()
{
    if (isEmptyFolder(typed()))
        QDialog::accept();
    else
        QFileDialog::accept();
}

/// Completion selects what exists, so that selectedFiles() names every folder on the way.
QString NewFolderDialog::typed() const
{
    const auto *name = findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
    return name && !name->text().isEmpty()
               ? QDir::cleanPath(directory().absoluteFilePath(name->text()))
               : QString();
}

} // namespace cradle
