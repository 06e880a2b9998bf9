// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/student_seed.h"

#include "model/files/json_schema.h"

#include <QCoreApplication>
#include <QMessageAuthenticationCode>
#include <QRandomGenerator>
#include <QtEndian>

namespace cradle {

namespace {

struct SeedText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr qint64 mostSecretBytes = 4096;
constexpr qsizetype leastSecretBytes = 16;

} // namespace

qint64 studentSeed(const QByteArray &secret, const QString &id)
{
    const QByteArray code =
        QMessageAuthenticationCode::hash(id.toUtf8(), secret, QCryptographicHash::Sha256);
    return static_cast<qint64>(qFromBigEndian<quint64>(code.constData()) >> 12) + 1;
}

Result<QByteArray> readSecret(const QString &path)
{
    const auto bytes = readFile(path, mostSecretBytes);
    if (!bytes)
        return bytes.error();
    QByteArray secret = bytes->trimmed();
    if (secret.size() < leastSecretBytes)
        return Error{.message = SeedText::tr("this is no secret: at least %1 letters are right")
                                    .arg(leastSecretBytes),
                     .file = path};
    return secret;
}

QByteArray newSecret()
{
    QByteArray bytes(32, Qt::Uninitialized);
    QRandomGenerator::system()->fillRange(reinterpret_cast<quint32 *>(bytes.data()),
                                          bytes.size() / 4);
    return bytes.toHex();
}

} // namespace cradle
