// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/judged_apart.h"

#include "tasks/grading/workers.h"
#include "tasks/script/script_limits.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>

namespace cradle::cli {

namespace {

struct ApartText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

constexpr int lookEvery = 60'000; ///< ms; there is nothing else to do
constexpr int mostKills = 3;

} // namespace

ServerProcess beginApart(const QString &language)
{
    return ServerProcess::bubblewrapped(QCoreApplication::applicationFilePath(), language);
}

Result<JudgedApart> judgeApart(const LabAtHand &lab, const JudgingRequest &request,
                               bool requireIsolation, ServerProcess begun)
{
    QString fault;
    for (int kills = 0; kills < mostKills; ++kills) {
        const auto workers =
            Workers::start(lab.lab, lab.files, lab.folder, lab.language,
                           QCoreApplication::applicationFilePath(), std::exchange(begun, {}));
        if (!workers)
            return workers.error();
        JudgedApart judged{.isolation = (*workers)->isolation()};
        if (requireIsolation && !judged.isolation.isWhole())
            return Error{.message = ApartText::tr("--require-isolation: this machine has only: %1")
                                        .arg(isolationText(judged.isolation))};
        QElapsedTimer timer;
        timer.start();
        (*workers)->judge(0, request);
        std::optional<WorkerEvent> ended;
        while (!ended) {
            for (WorkerEvent &event : (*workers)->wait(lookEvery)) {
                if (!event.step) {
                    ended = std::move(event);
                    continue;
                }
                if (!event.step->report)
                    return Error{.message = event.step->reason};
                judged.report = std::move(*event.step->report);
                judged.report.labId = lab.lab.id;
                judged.report.labHash = lab.lab.hash;
                judged.report.elapsedMs = timer.elapsed();
                return judged;
            }
        }
        fault = ended->fault;
        if (!ended->killed)
            break;
    }
    return Error{
        .message = ApartText::tr("there is no verdict; of the process that judged: %1").arg(fault)};
}

Result<QByteArray> readProgramBytes(const QString &path)
{
    const auto fault = [&](const QString &message) {
        return Error{.message = message, .file = path};
    };
    QFile file(path);
    const bool isInput = path == QLatin1String("-");
    if (!isInput && QFileInfo(path).isDir())
        return fault(ApartText::tr("this is a folder; a file is right"));
    const bool open = isInput ? file.open(0, QIODevice::ReadOnly) : file.open(QIODevice::ReadOnly);
    if (!open)
        return fault(ApartText::tr("cannot be read: %1").arg(file.errorString()));
    QByteArray bytes;
    while (bytes.size() <= limits::sourceBytes) {
        const QByteArray part = file.read(limits::sourceBytes + 1 - bytes.size());
        if (part.isEmpty())
            break;
        bytes += part;
    }
    return bytes;
}

} // namespace cradle::cli
