// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/patience.h"
#include "views/code/call_tip.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/code/completion_popup.h"
#include "views/theme.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include <memory>

namespace cradle {

inline QString s(const char *text)
{
    return QString::fromUtf8(text);
}

/// A window with a code pane between two other fields.
class OpenCode final
{
public:
    OpenCode()
    {
        auto *column = new QVBoxLayout(&window);
        column->addWidget(&before);
        column->addWidget(&pane, 1);
        column->addWidget(&after);
        window.resize(900, 500);
    }

    bool show()
    {
        window.show();
        window.activateWindow();
        const bool active = QTest::qWaitForWindowActive(&window, patience);
        editor().setFocus();
        return active;
    }

    [[nodiscard]] CodeEditor &editor() { return pane.editor(); }
    [[nodiscard]] static QWidget *focused() { return QApplication::focusWidget(); }
    void type(const char *text)
    {
        for (const QChar c : s(text)) {
            if (c == u'\n')
                QTest::keyClick(focused(), Qt::Key_Return);
            else
                QTest::keyClick(focused(), c.toLatin1());
        }
    }
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(focused(), static_cast<Qt::Key>(key), modifiers);
    }
    template <typename T>
    [[nodiscard]] T *shown(const QString &name = {})
    {
        for (T *each : window.findChildren<T *>()) {
            if (each->isVisible() && (name.isEmpty() || each->accessibleName().startsWith(name)))
                return each;
        }
        return nullptr;
    }
    [[nodiscard]] QStringList offered()
    {
        const auto *popup = shown<CompletionPopup>();
        return popup ? popup->words() : QStringList();
    }
    [[nodiscard]] QString tip()
    {
        const auto *tip = shown<CallTip>();
        return tip ? tip->text() : QString();
    }
    [[nodiscard]] bool says(const QString &text)
    {
        for (const auto *label : window.findChildren<QLabel *>()) {
            if (label->isVisible() && label->text() == text)
                return true;
        }
        return false;
    }

    QWidget window;
    QLineEdit before;
    CodePane pane;
    QLineEdit after;
};

/// A test of that window, which is each time another.
class CodeTest : public QObject
{
protected:
    void openAnew()
    {
        m_open = std::make_unique<OpenCode>();
        QVERIFY(m_open->show());
    }

    std::unique_ptr<OpenCode> m_open;
};

} // namespace cradle
