// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grade_run.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>

namespace cradle {

namespace {

constexpr int secondsToEnd = 5;                ///< before it is killed
constexpr qsizetype longestLine = 1024 * 1024; ///< bytes of an event
constexpr qsizetype longestFault = 2000;       ///< letters that are told

} // namespace

QStringList GradeOrder::arguments() const
{
    QStringList list{QStringLiteral("grade"),
                     QStringLiteral("--lab"),
                     lab,
                     QStringLiteral("--out"),
                     results,
                     QStringLiteral("--format"),
                     QStringLiteral("json"),
                     QStringLiteral("--language"),
                     language};
    if (!roster.isEmpty())
        list += {QStringLiteral("--roster"), roster};
    if (latePercent > 0.0)
        list += {QStringLiteral("--late-percent"), QString::number(latePercent)};
    if (again)
        list += QStringLiteral("--again");
    // A name may begin with a dash.
    return list + QStringList{QStringLiteral("--"), submissions};
}

GradeRun::GradeRun(QObject *parent)
    : QObject(parent)
    , m_path(QCoreApplication::applicationDirPath() + QStringLiteral("/cradle-cli"))
{
    connect(&m_process, &QProcess::readyReadStandardOutput, this, &GradeRun::readEvents);
    connect(&m_process, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
        finish(code, status == QProcess::CrashExit);
    });
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            emit ended(false, tr("%1 cannot be started: %2").arg(m_path, m_process.errorString()));
    });
}

GradeRun::~GradeRun()
{
    m_process.disconnect(this);
    if (!isRunning())
        return;
    m_process.terminate();
    if (!m_process.waitForFinished(secondsToEnd * 1000))
        m_process.kill();
    m_process.waitForFinished();
}

void GradeRun::start(const GradeOrder &order)
{
    if (isRunning())
        return;
    m_state = {};
    m_complete = false;
    m_process.start(m_path, order.arguments());
    m_process.closeWriteChannel();
}

void GradeRun::stop()
{
    m_process.terminate();
}

void GradeRun::readEvents()
{
    while (m_process.canReadLine())
        take(m_process.readLine(longestLine));
}

void GradeRun::take(const QByteArray &line)
{
    const QJsonObject json = QJsonDocument::fromJson(line).object();
    const QString event = json.value(QStringLiteral("event")).toString();
    if (event == QLatin1String("remark")) {
        emit remarked(json.value(QStringLiteral("text")).toString());
        return;
    }
    const auto count = [&](const char *key, int &value) {
        value = json.value(QLatin1String(key)).toInt(value);
    };
    count("students", m_state.students);
    count("done", m_state.done);
    count("kept", m_state.kept);
    count("passed", m_state.passed);
    count("failed", m_state.failed);
    count("not_graded", m_state.notGraded);
    m_complete = m_complete || event == QLatin1String("done");
    emit progressed(m_state);
}

void GradeRun::finish(int code, bool crashed)
{
    readEvents();
    if (m_complete && !crashed && code <= 1) {
        emit ended(true, {});
        return;
    }
    QString words =
        QString::fromUtf8(m_process.readAllStandardError()).trimmed().right(longestFault);
    // Here nobody asks which program says so, and in front of Arabic it turns the line around.
    if (words.startsWith(QLatin1String("cradle-cli: ")))
        words.remove(0, 12);
    emit ended(false, crashed && words.isEmpty() ? tr("cradle-cli broke down") : words);
}

} // namespace cradle
