// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "open_window.h"
#include "tests/git_home.h"
#include "tests/patience.h"

#include "views/code/code_editor.h"
#include "views/code/code_pane.h"

#include <QFile>
#include <QSignalSpy>

#include <memory>

namespace cradle::windows {

/// A student's files in a folder that is each test's own, and what a student does in a window.
class KeepingFixture
{
public:
    void begin() { m_folder = std::make_unique<QTemporaryDir>(); }

    [[nodiscard]] const QTemporaryDir &folder() const { return *m_folder; }
    [[nodiscard]] QString path(const char *name) const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    [[nodiscard]] QString work() const { return path("programs/lab-4.2"); }

private:
    GitHome m_home;
    std::unique_ptr<QTemporaryDir> m_folder;
};

inline void type(OpenWindow &open, const QString &text)
{
    open.window.codePane().editor().exchangeText(text);
    open.bench.code().edit(text);
    open.bench.code().save();
}

inline void inCode(OpenWindow &open)
{
    open.bench.setMode(Mode::Code);
}

/// Judges the program that is open and waits for the verdict.
inline void check(OpenWindow &open)
{
    QSignalSpy ended(&open.bench.check(), &WorkCheck::reported);
    open.bench.check().start();
    QVERIFY(ended.wait(patience));
    QTRY_VERIFY(!open.bench.check().awaitsRun());
}

inline QByteArray content(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace cradle::windows
