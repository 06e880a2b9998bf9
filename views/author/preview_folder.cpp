// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/preview_folder.h"

#include "model/file_io.h"

#include <QDir>

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

} // namespace

QString PreviewFolder::follow(const LabFiles &files, const QString &step)
{
    if (step != m_step) {
        m_step = step;
        m_written.clear();
        ++m_count; // names that the step before had mean other pictures now
    }
    const QString folder = m_folder.filePath(QString::number(m_count));
    const QString start = step + QLatin1Char('/');
    for (auto it = files.contents.lowerBound(start);
         it != files.contents.cend() && it.key().startsWith(start); ++it) {
        const QString name = it.key().mid(start.size());
        if (!isPicture(name) || m_written.value(name) == it.value())
            continue;
        QDir().mkpath(QFileInfo(folder + QLatin1Char('/') + name).path());
        if (!writeFile(folder + QLatin1Char('/') + name, it.value()))
            m_written.insert(name, it.value());
    }
    return folder;
}

} // namespace cradle
