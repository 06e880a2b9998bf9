// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/program_text.h"

#include "model/files/json_schema.h"
#include "tasks/script/script_limits.h"

#include <QCoreApplication>
#include <QList>
#include <QLocale>
#include <QStringDecoder>

namespace cradle {

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

/// Told by its mark, or by the NUL that every other byte of plain letters is.
std::optional<QStringConverter::Encoding> utf16(const QByteArray &bytes)
{
    if (bytes.startsWith("\xff\xfe"))
        return QStringConverter::Utf16LE;
    if (bytes.startsWith("\xfe\xff"))
        return QStringConverter::Utf16BE;
    qsizetype even = 0;
    qsizetype odd = 0;
    for (qsizetype i = 0; i < bytes.size(); ++i) {
        if (bytes[i] == '\0')
            ++(i % 2 == 0 ? even : odd);
    }
    const qsizetype most = bytes.size() / 4;
    if (odd > most && even < odd / 8)
        return QStringConverter::Utf16LE;
    if (even > most && odd < even / 8)
        return QStringConverter::Utf16BE;
    return std::nullopt;
}

} // namespace

Result<QString> programFrom(const QByteArray &bytes, const QString &path)
{
    if (bytes.size() > limits::sourceBytes) {
        return Error{.message =
                         ProgramText::tr("this is too long for a program; at most %1 are right")
                             .arg(QLocale::c().formattedDataSize(limits::sourceBytes)),
                     .file = path};
    }
    if (utf16(bytes))
        return Error{.message = ProgramText::tr("this is text in UTF-16; UTF-8 would be right"),
                     .file = path};
    if (const int line = firstBrokenLine(bytes); line > 0)
        return Error{.message = ProgramText::tr("this is no text in UTF-8, which would be right"),
                     .file = path,
                     .line = line};
    return QString::fromUtf8(bytes);
}

Result<QString> readProgram(const QString &path)
{
    const Result<QByteArray> bytes = readFile(path, limits::sourceBytes);
    return bytes ? programFrom(*bytes, path) : Result<QString>(bytes.error());
}

std::optional<QString> convertedProgram(const QByteArray &bytes)
{
    QString text;
    if (const auto encoding = utf16(bytes)) {
        QStringDecoder decode(*encoding);
        text = decode(bytes);
    } else {
        text = QString::fromLatin1(bytes);
    }
    text.remove(QChar(u'\0'));
    return text.toUtf8().size() <= limits::sourceBytes ? std::optional(text) : std::nullopt;
}

} // namespace cradle
