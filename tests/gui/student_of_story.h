// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/gui/open_window.h"
#include "tests/gui/writing_test.h"
#include "tests/patience.h"
#include "views/code/code_pane.h"

#include <QDropEvent>
#include <QInputDialog>
#include <QMimeData>

namespace cradle::windows {

/// Drops the file of the lab onto the student's window and tells his number.
inline void dropLab(OpenWindow &student, const QString &file, const char *number)
{
    QVERIFY(QTest::qWaitForWindowActive(&student.window, patience));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    const QPoint centre = student.window.rect().center();
    QDragEnterEvent enter(centre, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&student.window, &enter);
    QDropEvent drop(centre, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&student.window, &drop);
    QCOMPARE(student.bench.lab().title, QStringLiteral("Three laws"));
    QTRY_VERIFY(student.window.findChild<QInputDialog *>());
    auto *dialog = student.window.findChild<QInputDialog *>();
    QTRY_VERIFY(dialog->findChild<QLineEdit *>() && dialog->findChild<QLineEdit *>()->isVisible());
    QTest::keyClicks(dialog->findChild<QLineEdit *>(), QLatin1String(number));
    QTest::keyClick(dialog->findChild<QLineEdit *>(), Qt::Key_Return);
    QTRY_VERIFY(!student.bench.wantsNumber());
    student.bench.setMode(Mode::Code);
}

/// Types a program and presses Check.
inline void handIn(OpenWindow &student, const char *step, const QString &program)
{
    const int row = student.bench.lab().indexOf(utf8(step));
    QVERIFY(row >= 0);
    const QListWidgetItem *item = student.steps()->item(row);
    student.steps()->scrollToItem(item);
    QTest::mouseClick(student.steps()->viewport(), Qt::LeftButton, {},
                      student.steps()->visualItemRect(item).center());
    QTRY_COMPARE(student.bench.task()->id, utf8(step));
    retype(student.window.codePane().editor(), program);
    QTRY_COMPARE(student.bench.code().text(), program);
    student.check();
}

} // namespace cradle::windows
