// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace_lock.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSysInfo>
#include <QUuid>

#include <cerrno>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace cradle {

namespace {

constexpr qint64 mostLockBytes = 4096;

/// When the process began, in the kernel's ticks: its number may be another's by now.
qint64 startOf(qint64 process)
{
    const auto stat = readFile(QStringLiteral("/proc/%1/stat").arg(process), mostLockBytes);
    if (!stat)
        return 0;
    // The name, in parentheses, may hold anything.
    const QByteArray after = stat->mid(stat->lastIndexOf(')') + 2);
    const bool isDead = after.startsWith('Z'); // and nobody has asked how it ended
    return isDead ? 0 : after.split(' ').value(19).toLongLong();
}

struct Held {
    LockHolder holder;
    qint64 start = 0;
};

std::optional<Held> readLock(const QString &path)
{
    if (!QFile::exists(path))
        return std::nullopt;
    const auto text = readFile(path, mostLockBytes);
    const QJsonObject json = QJsonDocument::fromJson(text ? *text : QByteArray()).object();
    return Held{
        .holder = {.host = json.value(QStringLiteral("host")).toString(),
                   .process = static_cast<qint64>(json.value(QStringLiteral("process")).toDouble()),
                   .since = QDateTime::fromString(json.value(QStringLiteral("since")).toString(),
                                                  Qt::ISODate),
                   .token = json.value(QStringLiteral("token")).toString()},
        .start = static_cast<qint64>(json.value(QStringLiteral("start")).toDouble())};
}

QByteArray ourLock(const QString &token)
{
    const qint64 process = QCoreApplication::applicationPid();
    const QJsonObject json{
        {QStringLiteral("host"), QSysInfo::machineHostName()},
        {QStringLiteral("process"), process},
        {QStringLiteral("start"), startOf(process)},
        {QStringLiteral("since"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate)},
        {QStringLiteral("token"), token}};
    return QJsonDocument(json).toJson(QJsonDocument::Compact) + '\n';
}

bool isAlive(const Held &held)
{
    if (held.holder.host != QSysInfo::machineHostName())
        return !held.holder.token.isEmpty(); // a broken file is nobody's
    const auto number = static_cast<pid_t>(held.holder.process);
    if (number <= 0 || (::kill(number, 0) != 0 && errno != EPERM))
        return false;
    return held.start == 0 || held.start == startOf(held.holder.process);
}

} // namespace

WorkspaceLock::WorkspaceLock(const QString &folder)
    : m_path(folder + QLatin1Char('/') + QLatin1String(lockFileName))
{
}

WorkspaceLock::~WorkspaceLock()
{
    release();
}

WorkspaceLock::WorkspaceLock(WorkspaceLock &&other) noexcept
    : m_path(std::move(other.m_path))
    , m_token(std::exchange(other.m_token, {}))
    , m_killedSince(std::move(other.m_killedSince))
{
}

WorkspaceLock &WorkspaceLock::operator=(WorkspaceLock &&other) noexcept
{
    if (this != &other) {
        release();
        m_path = std::move(other.m_path);
        m_token = std::exchange(other.m_token, {});
        m_killedSince = std::move(other.m_killedSince);
    }
    return *this;
}

std::optional<LockHolder> WorkspaceLock::take()
{
    if (isHeld())
        return std::nullopt;
    const QString token = QUuid::createUuid().toString(QUuid::WithoutBraces);
    // A name of its own that is linked to the lock's: only one of two can do that.
    const QString own = m_path + QLatin1Char('-') + token;
    if (writeFile(own, ourLock(token)))
        return std::nullopt;
    const QByteArray ownName = QFile::encodeName(own);
    const QByteArray name = QFile::encodeName(m_path);
    std::optional<LockHolder> other;
    for (int attempt = 0; attempt < 3; ++attempt) {
        other.reset();
        if (::link(ownName.constData(), name.constData()) == 0) {
            m_token = token;
            break;
        }
        const auto held = readLock(m_path);
        if (held && isAlive(*held)) {
            other = held->holder;
            break;
        }
        if (held) {
            m_killedSince = held->holder.since;
            QFile::remove(m_path); // of a window that was killed
        } else if (errno != EEXIST) {
            takeOver(); // a disk without links
            break;
        }
    }
    QFile::remove(own);
    return other;
}

void WorkspaceLock::takeOver()
{
    const QString token = QUuid::createUuid().toString(QUuid::WithoutBraces);
    if (!writeFile(m_path, ourLock(token)))
        m_token = token;
}

bool WorkspaceLock::isHeld() const
{
    if (m_token.isEmpty())
        return false;
    const auto held = readLock(m_path);
    return held && held->holder.token == m_token;
}

void WorkspaceLock::release()
{
    if (isHeld())
        QFile::remove(m_path);
    m_token.clear();
}

} // namespace cradle
