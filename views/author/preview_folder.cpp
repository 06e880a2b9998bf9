// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/preview_folder.h"

#include "model/files/file_io.h"

#include <QCoreApplication>
#include <QDir>

#include <cerrno>
#include <csignal>

namespace cradle {

namespace {

bool isPicture(const QString &path)
{
    for (const char *ending : {".svg", ".png", ".jpg", ".jpeg", ".gif"}) {
        if (path.endsWith(QLatin1String(ending), Qt::CaseInsensitive))
            return true;
    }
    return false;
}

const QString folderStart = QStringLiteral("cradle-preview-");

void removeLeftBehind()
{
    const QDir temporary = QDir::temp();
    for (const QString &name : temporary.entryList({folderStart + QLatin1Char('*')}, QDir::Dirs)) {
        const auto process = name.mid(folderStart.size()).section(QLatin1Char('-'), 0, 0).toInt();
        if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH)
            QDir(temporary.filePath(name)).removeRecursively();
    }
}

} // namespace

QString PreviewFolder::follow(const LabFiles &files, const QString &step)
{
    if (step != m_step) {
        m_step = step;
        m_written.clear();
        ++m_count; // names that the step before had mean other pictures now
    }
    const QString start = step + QLatin1Char('/');
    for (auto it = files.contents.lowerBound(start);
         it != files.contents.cend() && it.key().startsWith(start); ++it) {
        const QString name = it.key().mid(start.size());
        if (!isPicture(name) || m_written.value(name) == it.value())
            continue;
        if (!m_folder) {
            removeLeftBehind();
            m_folder = std::make_unique<QTemporaryDir>(
                QDir::temp()
                    .filePath(folderStart + QStringLiteral("%1-XXXXXX"))
                    .arg(QCoreApplication::applicationPid()));
        }
        const QString folder = m_folder->filePath(QString::number(m_count));
        QDir().mkpath(QFileInfo(folder + QLatin1Char('/') + name).path());
        if (!writeFile(folder + QLatin1Char('/') + name, it.value()))
            m_written.insert(name, it.value());
    }
    return m_folder ? m_folder->filePath(QString::number(m_count)) : QString();
}

} // namespace cradle
