// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/language.h"
#include "app/main_window.h"
#include "app/notice_bar.h"
#include "model/files/preset_json.h"
#include "tasks/reading/lab_reader.h"
#include "tests/gui/typed_cell.h"
#include "tests/patience.h"
#include "views/inspector/circle_table_model.h"
#include "views/inspector/inspector.h"
#include "views/inspector/number_field.h"
#include "views/scene/scene_view.h"
#include "views/task_pane/step_delegate.h"
#include "views/task_pane/task_pane.h"
#include "views/transport_bar.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace cradle::windows {

/// The whole application as a student has it open; progress and settings lie in \p folder.
class OpenWindow
{
public:
    explicit OpenWindow(const QTemporaryDir &folder)
        : settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat)
        , bench(folder.filePath(QStringLiteral("progress.json")))
        , window(bench, settings, ThemeChoice::Light)
    {
        if (const auto error = bench.openLab(QLatin1String(shippedLab), currentLanguage()))
            qFatal("%s", qPrintable(error->toString()));
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window,
                                         patience)) // keys and focus are for the active one
            qFatal("the window does not become active");
    }

    [[nodiscard]] Simulation &simulation() { return bench.simulation(); }
    [[nodiscard]] const Preset &preset() { return bench.document().preset(); }
    [[nodiscard]] QListWidget *steps() { return window.taskPane().findChild<QListWidget *>(); }
    [[nodiscard]] bool isTicked(int step)
    {
        return steps()->item(step)->data(StepDelegate::stateRole).toInt()
               == static_cast<int>(StepDelegate::State::Passed);
    }

    /// The visible button that is called so, or begins so.
    [[nodiscard]] QAbstractButton *button(const QString &name)
    {
        for (auto *each : window.findChildren<QAbstractButton *>()) {
            if (each->isVisible()
                && (each->accessibleName().startsWith(name) || each->text().startsWith(name)))
                return each;
        }
        return nullptr;
    }
    void click(const QString &name)
    {
        QAbstractButton *found = button(name);
        QVERIFY2(found && found->isEnabled(), qPrintable(name));
        QTest::mouseClick(found, Qt::LeftButton);
    }
    /// Whether a label that is seen contains \p part.
    [[nodiscard]] bool says(const QString &part)
    {
        for (const auto *label : window.findChildren<QLabel *>()) {
            if (label->isVisible() && label->text().contains(part))
                return true;
        }
        return false;
    }
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(&window.scene(), static_cast<Qt::Key>(key), modifiers);
    }

    /// Types a number into the table of circles, as a student does.
    void typeCell(int row, int column, const QString &text)
    {
        typeIntoCell(window.inspector().findChild<QTableView *>(), row, column, text);
    }

    [[nodiscard]] Preset solution()
    {
        return *readPreset(bench.task()->folder + QStringLiteral("/solution-preset.json"));
    }
    /// Presses Check and waits for the verdict.
    void check()
    {
        click(QStringLiteral("Check"));
        QTRY_VERIFY(bench.check().report() && !window.transportBar().isChecking()
                    && !bench.check().awaitsRun());
    }

    QSettings settings;
    Workbench bench;
    MainWindow window;
};

} // namespace cradle::windows
