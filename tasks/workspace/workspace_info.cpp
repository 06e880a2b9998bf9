// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace_info.h"

#include "model/files/json_schema.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

namespace cradle {

namespace {

struct InfoText {
    Q_DECLARE_TR_FUNCTIONS(Workspace)
};

constexpr qint64 mostInfoBytes = 64 * 1024;

struct Field {
    const char *key;
    QString WorkspaceInfo::*field;
};

constexpr Field fields[] = {{"lab", &WorkspaceInfo::labId},
                            {"version", &WorkspaceInfo::labVersion},
                            {"lab_hash", &WorkspaceInfo::labHash},
                            {"name", &WorkspaceInfo::student},
                            {"id", &WorkspaceInfo::studentId}};

QString pathIn(const QString &folder)
{
    return folder + QStringLiteral("/cradle.json");
}

} // namespace

bool isWorkspace(const QString &folder)
{
    return QFileInfo(pathIn(folder)).isFile();
}

Result<WorkspaceInfo> readWorkspaceInfo(const QString &folder)
{
    if (!isWorkspace(folder))
        return WorkspaceInfo{};
    const auto text = readFile(pathIn(folder), mostInfoBytes);
    return text ? workspaceInfoFrom(*text, pathIn(folder)) : Result<WorkspaceInfo>(text.error());
}

Result<WorkspaceInfo> workspaceInfoFrom(const QByteArray &text, const QString &source)
{
    const QJsonObject json = QJsonDocument::fromJson(text).object();
    if (json.value(QStringLiteral("format")).toInt() != 1)
        return Error{.message = InfoText::tr("this does not say whose work it is, as cradle.json "
                                             "of format 1 does"),
                     .file = source};
    WorkspaceInfo info;
    for (const Field &each : fields)
        info.*each.field = json.value(QLatin1String(each.key)).toString().simplified();
    return info;
}

QByteArray textOf(const WorkspaceInfo &info)
{
    QJsonObject json{{QStringLiteral("format"), 1}};
    for (const Field &each : fields) {
        if (!(info.*each.field).isEmpty())
            json.insert(QLatin1String(each.key), info.*each.field);
    }
    return QJsonDocument(json).toJson();
}

} // namespace cradle
