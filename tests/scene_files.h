// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QTest>

/// The scene files of the fixtures.
namespace cradle::scenes {

inline QString fixture(const QString &name)
{
    return QFINDTESTDATA(QStringLiteral("fixtures/presets/%1.json").arg(name));
}

inline QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace cradle::scenes
