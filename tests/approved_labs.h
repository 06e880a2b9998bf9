// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/approved_text.h"

#include <QTest>

/// What the tests of tests/approved/labs share.
namespace cradle::approved {

inline QString u(const char *text)
{
    return QString::fromUtf8(text);
}

/// Fails the test where \p now is not what the file says.
inline void verifyLabs(const char *file, QString now)
{
    now.replace(fixturePath(""), QStringLiteral("FIXTURES/"));
    const QString different = compare(QStringLiteral("labs/") + u(file), now);
    QVERIFY2(different.isEmpty(), qPrintable(different));
}

} // namespace cradle::approved
