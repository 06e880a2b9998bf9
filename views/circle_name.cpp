// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/circle_name.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace cradle {

namespace {

struct NameText {
    Q_DECLARE_TR_FUNCTIONS(CircleName)
};

/// The digits of \p name where it is \p pattern with a number for %1; else empty.
QString numberIn(const QString &name, const QString &pattern)
{
    const QStringList around = pattern.split(QStringLiteral("%1"));
    if (around.size() != 2 || !name.startsWith(around[0]) || !name.endsWith(around[1]))
        return {};
    static const QRegularExpression number(QStringLiteral("^[1-9][0-9]{0,8}$"));
    const QString middle =
        name.mid(around[0].size(), name.size() - around[0].size() - around[1].size());
    return number.match(middle).hasMatch() ? middle : QString();
}

const QString keptName = QStringLiteral("circle %1");

} // namespace

QString plainCircleName(std::size_t number)
{
    return keptName.arg(number);
}

QString shownCircleName(const QString &name)
{
    const QString number = numberIn(name, keptName);
    return number.isEmpty() ? name : NameText::tr("circle %1").arg(number);
}

QString keptCircleName(const QString &shown)
{
    const QString number = numberIn(shown, NameText::tr("circle %1"));
    return number.isEmpty() ? shown : keptName.arg(number);
}

} // namespace cradle
