// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab_drop.h"

#include "tasks/reading/lab_archive.h"
#include "tasks/work/work_archive.h"

#include <QApplication>
#include <QDropEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>
#include <QWidget>

namespace cradle {

namespace {

/// The lab that is dragged; empty if it is something else.
QString labIn(const QMimeData &data)
{
    const QList<QUrl> urls = data.urls();
    if (urls.size() != 1 || !urls.front().isLocalFile())
        return {};
    const QString path = urls.front().toLocalFile();
    const bool isFolder = QFileInfo::exists(path + QStringLiteral("/lab.json"));
    return isFolder || isLabArchive(path) || isWorkArchive(path) ? path : QString();
}

bool isDrag(QEvent::Type type)
{
    return type == QEvent::DragEnter || type == QEvent::DragMove || type == QEvent::Drop;
}

} // namespace

LabDrop::LabDrop(QWidget *window)
    : QObject(window)
    , m_window(window)
{
    window->setAcceptDrops(true);
    qApp->installEventFilter(this);
}

LabDrop::~LabDrop()
{
    qApp->removeEventFilter(this);
}

bool LabDrop::eventFilter(QObject *watched, QEvent *event)
{
    const auto *widget = isDrag(event->type()) ? qobject_cast<QWidget *>(watched) : nullptr;
    if (!widget || widget->window() != m_window || QApplication::activeModalWidget())
        return QObject::eventFilter(watched, event);
    auto *drag = static_cast<QDropEvent *>(event);
    const QString lab = labIn(*drag->mimeData());
    if (lab.isEmpty())
        return QObject::eventFilter(watched, event);
    drag->acceptProposedAction();
    if (event->type() == QEvent::Drop)
        emit dropped(lab);
    return true;
}

Result<QString> labFolder(const QString &path, QWidget *asker)
{
    if (QFileInfo(path).isDir())
        return path;
    const auto older = olderThan(path);
    if (!older)
        return importLab(path);
    const auto named = [](const QString &version) {
        return version.isEmpty() ? LabDrop::tr("no version")
                                 : LabDrop::tr("version %1").arg(version);
    };
    QMessageBox box(QMessageBox::Question, LabDrop::tr("Another version"),
                    LabDrop::tr("“%1” is there already with %2. The file has %3.")
                        .arg(older->lab.title, named(older->lab.version), named(older->newVersion)),
                    QMessageBox::Cancel, asker);
    box.setInformativeText(LabDrop::tr("Both have one id, so what was passed in one counts as "
                                       "passed in the other."));
    auto *replace = box.addButton(LabDrop::tr("Replace it"), QMessageBox::AcceptRole);
    auto *both = box.addButton(LabDrop::tr("Keep both"), QMessageBox::NoRole);
    box.setDefaultButton(both);
    box.exec();
    if (box.clickedButton() == replace)
        return importLab(path, userLabsFolder(), older->lab.folder);
    return box.clickedButton() == both ? importLab(path) : Result<QString>(QString());
}

} // namespace cradle
