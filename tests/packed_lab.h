// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/authoring_labs.h"
#include "tests/zip_maker.h"

namespace cradle::authoring {

/// The files of a lab in an archive, below the folder \p before.
inline ZipMaker zipOf(const LabFiles &files, const QByteArray &before = {})
{
    ZipMaker zip;
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it)
        zip.add({.name = before + it.key().toUtf8(), .content = *it});
    return zip;
}

/// The names in a folder, hidden ones too.
inline QStringList everythingIn(const QString &folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::System
                                  | QDir::NoDotAndDotDot);
}

} // namespace cradle::authoring
