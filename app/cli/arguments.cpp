// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#include <QCoreApplication>
#include <QStringDecoder>

#include <fcntl.h>

namespace cradle::cli {

namespace {

struct ArgumentsText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

std::optional<QString> asText(const QByteArray &bytes)
{
    QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    QString text = decode(bytes);
    return decode.hasError() ? std::nullopt : std::optional(std::move(text));
}

Result<QString> pathOf(const QByteArray &bytes)
{
    const int file = open(bytes.constData(), O_PATH | O_CLOEXEC);
    if (file < 0)
        return Error{.message = ArgumentsText::tr("there is nothing of that name; the name of "
                                                  "something new must be UTF-8"),
                     .file = QString::fromUtf8(bytes)};
    return QStringLiteral("/proc/self/fd/%1").arg(file);
}

} // namespace

Result<QStringList> textsOf(int argc, char **argv)
{
    QStringList texts;
    for (int i = 1; i < argc; ++i) {
        const QByteArray bytes(argv[i]);
        if (const auto text = asText(bytes)) {
            texts.append(*text);
            continue;
        }
        const qsizetype equals = bytes.startsWith("--") ? bytes.indexOf('=') : -1;
        const auto option = asText(bytes.left(equals + 1));
        const auto path = pathOf(option ? bytes.mid(equals + 1) : bytes);
        if (!path)
            return path.error();
        texts.append(option.value_or(QString()) + *path);
    }
    return texts;
}

} // namespace cradle::cli
