// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/test_paths.h"

#include <QFile>

/// The scene files of the fixtures.
namespace cradle::scenes {

inline QString fixture(const QString &name)
{
    return fixturePath("presets/") + name + QStringLiteral(".json");
}

inline QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace cradle::scenes
