// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/files/file_io.h"
#include "tests/patience.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace cradle::pages {

/// Whether Python's parser finds every element closed and no other than we write; and whether Tidy
/// has nothing to say, where it is installed.
inline QByteArray faultsOf(const QByteArray &html)
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("page.html"));
    if (writeFile(path, html))
        return "cannot be written";
    const QString script = QStringLiteral(R"py(
import html.parser, sys
VOID = {'meta', 'br', 'rect', 'circle', 'polyline', 'polygon'}
OPTIONAL = {'td', 'th', 'tr'}
KNOWN = VOID | OPTIONAL | set('''html head title style body header main footer h1 h2 h3 h4 p ul ol li
    a b i bdi code pre span div section table caption thead tbody details summary figure figcaption
    svg text'''.split())
class Reader(html.parser.HTMLParser):
    stack, faults, ids = [], [], set()
    def handle_starttag(self, tag, attributes):
        if tag not in KNOWN: self.faults.append('unknown ' + tag)
        for name, value in attributes:
            if name.startswith('on'): self.faults.append('script in ' + name)
            if name == 'id' and value in self.ids: self.faults.append('twice ' + value)
            if name == 'id': self.ids.add(value)
        if tag in ('td', 'th', 'tr'):
            while self.stack and self.stack[-1] in OPTIONAL and (tag == 'tr' or self.stack[-1] != 'tr'):
                self.stack.pop()
        if tag not in VOID: self.stack.append(tag)
    def handle_startendtag(self, tag, attributes):
        if tag not in VOID: self.faults.append('empty ' + tag)
    def handle_endtag(self, tag):
        while self.stack and self.stack[-1] != tag and self.stack[-1] in OPTIONAL: self.stack.pop()
        if not self.stack or self.stack[-1] != tag: self.faults.append('stray end of ' + tag)
        else: self.stack.pop()
reader = Reader()
reader.feed(open(sys.argv[1], encoding='utf-8').read())
reader.close()
print('\n'.join(reader.faults + ['open ' + tag for tag in reader.stack]), end='')
)py");
    const auto run = [](const QString &program, const QStringList &arguments) {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(program, arguments);
        if (!process.waitForFinished(patience))
            return QByteArray("does not run");
        return process.readAll();
    };
    QByteArray faults = run(QStringLiteral("python3"), {QStringLiteral("-c"), script, path});
    if (!QStandardPaths::findExecutable(QStringLiteral("tidy")).isEmpty())
        faults += run(QStringLiteral("tidy"),
                      {QStringLiteral("-q"), QStringLiteral("-e"),
                       QStringLiteral("--drop-empty-elements"), QStringLiteral("no"), path});
    return faults;
}

} // namespace cradle::pages
