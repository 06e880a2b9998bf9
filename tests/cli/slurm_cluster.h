// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/cli/program_run.h"
#include "tests/patience.h"

#include <QDir>
#include <QRandomGenerator>
#include <QStandardPaths>
#include <QSysInfo>

#include <memory>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace cradle::programs {

/// A port of 127.0.0.1 that nobody has at the moment.
inline int freePort()
{
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto *place = reinterpret_cast<sockaddr *>(&address);
    const bool bound = bind(socket, place, size) == 0 && getsockname(socket, place, &size) == 0;
    close(socket);
    return bound ? ntohs(address.sin_port) : 0;
}

/// A cluster of two nodes on this machine: munge, slurmctld and two of slurmd, on the loopback, as
/// whoever runs the test. It ends with this object.
class SlurmCluster
{
public:
    /// The programs that are not installed, or why the cluster cannot be had here; empty: it runs.
    [[nodiscard]] QString start()
    {
        QStringList lacking;
        for (const char *name : {"munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo"}) {
            if (found(name).isEmpty())
                lacking.append(QString::fromUtf8(name));
        }
        if (!lacking.isEmpty())
            return QStringLiteral("not installed: ") + lacking.join(QStringLiteral(", "));
        if (!configure())
            return QStringLiteral("no folder for the cluster can be made");
        launch("munged", {QStringLiteral("--foreground"), QStringLiteral("--force"),
                          QStringLiteral("--key-file=") + at("munge.key"),
                          QStringLiteral("--socket=") + at("munge.sock"),
                          QStringLiteral("--pid-file=") + at("munge.pid"),
                          QStringLiteral("--seed-file=") + at("munge.seed"),
                          QStringLiteral("--log-file=") + at("munge.log")});
        if (!QTest::qWaitFor([this] { return QFile::exists(at("munge.sock")); }, 10'000))
            return QStringLiteral("munged does not start: ") + words();
        launch("slurmctld", {QStringLiteral("-D")});
        for (const char *node : {"one", "two"})
            launch("slurmd", {QStringLiteral("-D"), QStringLiteral("-N"), QLatin1String(node)});
        const bool ready = QTest::qWaitFor(
            [this] {
                return ask("sinfo", {QStringLiteral("-h"), QStringLiteral("-o%D %t")}).out.trimmed()
                       == QLatin1String("2 idle");
            },
            30'000);
        return ready ? QString() : QStringLiteral("Slurm does not start: ") + words();
    }

    ~SlurmCluster()
    {
        for (auto it = m_daemons.rbegin(); it != m_daemons.rend(); ++it) {
            (*it)->terminate();
            if (!(*it)->waitForFinished(10'000))
                (*it)->kill();
            (*it)->waitForFinished();
        }
    }

    /// Submits a job by the arguments of sbatch. \return its number; empty if it was refused
    [[nodiscard]] QString submit(const QStringList &arguments,
                                 const QMap<QString, QString> &variables = {}) const
    {
        QStringList line{QStringLiteral("--parsable"), QStringLiteral("--output"),
                         at("task-%A-%a.txt")};
        const Outcome outcome = ask("sbatch", line + arguments, variables);
        return outcome.code == 0 ? outcome.out.trimmed() : QString();
    }
    /// Waits until no task of the job is to run or runs any more.
    [[nodiscard]] bool finishes(const QString &job) const
    {
        return QTest::qWaitFor(
            [&] {
                const Outcome left =
                    ask("squeue", {QStringLiteral("-h"), QStringLiteral("-j"), job,
                                   QStringLiteral("-t"), QStringLiteral("PD,R,S,CG")});
                return left.ended && left.out.trimmed().isEmpty();
            },
            patience);
    }
    /// What Slurm calls the end of a task: COMPLETED, FAILED.
    [[nodiscard]] QString endOf(const QString &job, int task) const
    {
        return ask("squeue", {QStringLiteral("-h"), QStringLiteral("-t"), QStringLiteral("all"),
                              QStringLiteral("-j"), QStringLiteral("%1_%2").arg(job).arg(task),
                              QStringLiteral("-o%T")})
            .out.trimmed();
    }
    /// What the cluster and its tasks have written, for a test that failed.
    [[nodiscard]] QString words() const
    {
        QString all;
        for (const QString &name :
             QDir(m_folder.path())
                 .entryList({QStringLiteral("*.log"), QStringLiteral("*.txt")}, QDir::Files))
            all += name + QStringLiteral(": ")
                   + QString::fromUtf8(contentOf(m_folder.filePath(name)).right(600));
        return all;
    }

private:
    static QString found(const char *name)
    {
        const QString program = QStandardPaths::findExecutable(QLatin1String(name));
        return program.isEmpty() ? QStandardPaths::findExecutable(QLatin1String(name),
                                                                  {QStringLiteral("/usr/sbin")})
                                 : program;
    }
    [[nodiscard]] QString at(const char *name) const
    {
        return m_folder.filePath(QLatin1String(name));
    }

    bool configure()
    {
        // Who speaks to munge goes through the folder; what is secret in it says so by itself.
        QFile::setPermissions(m_folder.path(), QFile::ReadOwner | QFile::WriteOwner
                                                   | QFile::ExeOwner | QFile::ExeGroup
                                                   | QFile::ExeOther);
        QByteArray secret(128, '\0');
        for (char &byte : secret)
            byte = static_cast<char>(QRandomGenerator::system()->bounded(256));
        QFile key(at("munge.key"));
        if (!key.open(QIODevice::WriteOnly) || key.write(secret) != secret.size())
            return false;
        key.setPermissions(QFile::ReadOwner);
        QDir(m_folder.path()).mkdir(QStringLiteral("state"));
        const QByteArray host = QSysInfo::machineHostName().section(u'.', 0, 0).toUtf8();
        const QByteArray text =
            "ClusterName=cradle\n"
            "SlurmctldHost=HOST(127.0.0.1)\n"
            "SlurmUser=USER\nSlurmdUser=USER\n"
            "AuthType=auth/munge\nAuthInfo=socket=FOLDER/munge.sock\nCredType=cred/munge\n"
            "SlurmctldPort=PORT\n"
            "ProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nSwitchType=switch/none\n"
            "JobAcctGatherType=jobacct_gather/none\nMpiDefault=none\n"
            "AccountingStorageType=accounting_storage/none\n"
            "SelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\n"
            "SchedulerParameters=batch_sched_delay=0,sched_interval=1\n"
            "StateSaveLocation=FOLDER/state\nSlurmdSpoolDir=FOLDER/%n\n"
            "SlurmctldPidFile=FOLDER/slurmctld.pid\nSlurmdPidFile=FOLDER/%n.pid\n"
            "SlurmctldLogFile=FOLDER/slurmctld.log\nSlurmdLogFile=FOLDER/%n.log\n"
            "NodeName=one NodeHostname=HOST NodeAddr=127.0.0.1 Port=PORT CPUs=1\n"
            "NodeName=two NodeHostname=HOST NodeAddr=127.0.0.1 Port=PORT CPUs=1\n"
            "PartitionName=all Nodes=one,two Default=YES State=UP\n";
        return configureWith(text, host);
    }
    bool configureWith(QByteArray text, const QByteArray &host)
    {
        text.replace("FOLDER", m_folder.path().toUtf8());
        text.replace("HOST", host);
        text.replace("USER", QByteArray::number(getuid()));
        for (qsizetype place = 0; (place = text.indexOf("PORT")) >= 0;)
            text.replace(place, 4, QByteArray::number(freePort()));
        QFile file(at("slurm.conf"));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    }

    void launch(const char *name, const QStringList &arguments)
    {
        auto process = std::make_unique<QProcess>();
        process->setProcessEnvironment(environment({}));
        process->setStandardOutputFile(at(name) + QStringLiteral(".log"), QIODevice::Append);
        process->setStandardErrorFile(at(name) + QStringLiteral(".log"), QIODevice::Append);
        process->start(found(name), arguments);
        process->waitForStarted();
        m_daemons.push_back(std::move(process));
    }
    [[nodiscard]] Outcome ask(const char *name, const QStringList &arguments,
                              const QMap<QString, QString> &variables = {}) const
    {
        return run(found(name), arguments, {}, environment(variables));
    }
    [[nodiscard]] QProcessEnvironment environment(const QMap<QString, QString> &variables) const
    {
        QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
        all.insert(QStringLiteral("SLURM_CONF"), at("slurm.conf"));
        for (auto it = variables.begin(); it != variables.end(); ++it)
            all.insert(it.key(), *it);
        return all;
    }

    QTemporaryDir m_folder{};
    std::vector<std::unique_ptr<QProcess>> m_daemons{};
};

} // namespace cradle::programs
