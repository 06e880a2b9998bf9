// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_source.h"

#include "model/files/json_schema.h"
#include "model/files/preset_json.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringDecoder>

#include <algorithm>

namespace cradle {

namespace {

struct SourceText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

/// Far above what a step needs; a larger text is a mistake.
constexpr qint64 maxTextBytes = 2 * 1024 * 1024;

} // namespace

LabSource::LabSource(const LabFiles &files, const QString &folder, std::vector<Error> faults)
    : m_files(files)
    , m_folder(folder)
    , m_faults(std::move(faults))
{
}

bool LabSource::has(const QString &path) const
{
    if (m_files.contents.contains(path))
        return true;
    // One that cannot be read is there all the same, and will be told.
    const QString full = fullPath(path);
    return std::any_of(m_faults.begin(), m_faults.end(),
                       [&](const Error &fault) { return fault.file == full; });
}

QString LabSource::fullPath(const QString &path) const
{
    return m_folder + QLatin1Char('/') + path;
}

Result<QByteArray> LabSource::read(const QString &path, qint64 maxBytes) const
{
    const QString full = fullPath(path);
    const auto found = m_files.contents.find(path);
    if (found != m_files.contents.end()) {
        if (found->size() <= maxBytes)
            return *found;
        return Error{.message = SourceText::tr("the file is too large; at most %1 are right")
                                    .arg(QLocale::c().formattedDataSize(maxBytes)),
                     .file = full};
    }
    for (const Error &fault : m_faults) {
        if (fault.file == full)
            return fault;
    }
    return Error{.message = SourceText::tr("cannot be read: there is no such file"), .file = full};
}

Result<QJsonObject> LabSource::readJson(const QString &path, const char *schema) const
{
    const Result<QByteArray> text = read(path, maxTextBytes);
    if (!text)
        return text.error();
    return parseJson(*text, QLatin1String(":/schemas/") + QLatin1String(schema), fullPath(path));
}

Result<Preset> LabSource::readPreset(const QString &path) const
{
    const Result<QByteArray> text = read(path, limits::labFileBytes);
    return text ? parsePreset(*text, fullPath(path)) : Result<Preset>(text.error());
}

QString LabSource::readText(const QString &path, qint64 maxBytes,
                            std::vector<Error> &findings) const
{
    const Result<QByteArray> text = read(path, std::min(maxBytes, maxTextBytes));
    if (!text) {
        findings.push_back(text.error());
        return {};
    }
    QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    QString decoded = decode(*text);
    if (decode.hasError())
        findings.push_back({.message = SourceText::tr("the text is not in UTF-8, which would "
                                                      "be right; some letters are lost"),
                            .file = fullPath(path)});
    if (const qsizetype nul = decoded.indexOf(QChar::Null); nul >= 0) {
        findings.push_back(
            {.message = SourceText::tr("the text has characters that are none (NUL); a text in "
                                       "UTF-8 is right"),
             .file = fullPath(path),
             .line = static_cast<int>(1 + decoded.left(nul).count(QLatin1Char('\n')))});
        decoded.remove(QChar::Null);
    }
    return decoded;
}

std::vector<Error> LabSource::untold(const std::vector<Error> &findings) const
{
    std::vector<Error> rest;
    for (const Error &fault : m_faults) {
        if (std::find(findings.begin(), findings.end(), fault) == findings.end())
            rest.push_back(fault);
    }
    return rest;
}

} // namespace cradle
