// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/program_file.h"

#include "model/json_schema.h"
#include "tasks/script/script_limits.h"

#include <QCoreApplication>
#include <QList>
#include <QStringDecoder>

namespace cradle::cli {

namespace {

struct ProgramText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// The first line, from 1, that is no text; 0 if all are. No letter of UTF-8 spans two lines.
int firstBrokenLine(const QByteArray &text)
{
    int number = 0;
    for (const QByteArray &line : text.split('\n')) {
        ++number;
        QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
        const QString decoded = decode(line);
        if (decode.hasError() || decoded.contains(QChar(u'\0')))
            return number;
    }
    return 0;
}

} // namespace

Result<QString> readProgram(const QString &path)
{
    const Result<QByteArray> text = readFile(path, limits::sourceBytes);
    if (!text)
        return text.error();
    if (const int line = firstBrokenLine(*text); line > 0)
        return Error{.message = ProgramText::tr("this is no text in UTF-8, which would be right"),
                     .file = path,
                     .line = line};
    return QString::fromUtf8(*text);
}

} // namespace cradle::cli
