// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/work_job.h"

#include <QDateTime>
#include <QtConcurrentRun>

namespace cradle {

namespace {

constexpr qint64 seed = 1; ///< of all reports: the same work is told the same

} // namespace

WorkJob::WorkJob(QObject *parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, [this] {
        if (!m_stop || *m_stop)
            return;
        const auto result = m_watcher.result();
        if (*result)
            m_setting.start(formulasOf((*result)->report));
        else
            emit failed(result->error());
    });
    connect(&m_setting, &FormulaSetting::done, this, [this](const SetFormulas &formulas) {
        if (*m_stop)
            return;
        HandIn handIn = **m_watcher.result();
        handIn.report.formulas = formulas;
        emit finished(handIn);
    });
}

WorkJob::~WorkJob()
{
    cancel();
    m_watcher.waitForFinished();
}

void WorkJob::start(const Lab &lab, const QString &folder, const Sender &sender)
{
    cancel();
    m_stop = std::make_shared<std::atomic_bool>(false);
    const auto tell = [this, stop = m_stop](int done, int total) {
        QMetaObject::invokeMethod(this, [this, stop, done, total] {
            if (!*stop)
                emit progressed(done, total);
        });
    };
    m_watcher.setFuture(QtConcurrent::run([lab, folder, sender, tell, stop = m_stop] {
        return std::make_shared<const Result<HandIn>>(gatherHandIn(
            lab, folder, sender, seed, QDateTime::currentDateTimeUtc(), tell, stop.get()));
    }));
}

QString unsavedText()
{
    return WorkJob::tr("What you typed last could not be saved; on the disk your work is older. "
                       "Save it first: the window says what is in the way.");
}

void WorkJob::cancel()
{
    if (m_stop)
        *m_stop = true;
}

} // namespace cradle
