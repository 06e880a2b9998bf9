// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/patience.h"
#include "views/circle_edits.h"
#include "views/inspector/inspector.h"
#include "views/inspector/number_field.h"
#include "views/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTest>

namespace cradle {

inline Preset inspectedScene()
{
    Preset preset;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete};
    PresetCircle first;
    first.name = QStringLiteral("circle 1");
    first.body.position = {-2.0, 0.0};
    PresetCircle second = first;
    second.name = QStringLiteral("circle 2");
    second.colour = QStringLiteral("#e03131");
    second.body.position = {2.0, 0.0};
    preset.circles = {first, second};
    return preset;
}

/// An inspector that is shown, the scene that it edits, and ways to its controls.
class OpenInspector final
{
public:
    /// \return whether it has the focus
    bool show();

    [[nodiscard]] NumberField *field(const QString &name) const;
    [[nodiscard]] QComboBox *law(const QString &name) const;
    [[nodiscard]] QPushButton *button(const QString &name) const;
    [[nodiscard]] QTableView *table() const { return inspector.findChild<QTableView *>(); }
    [[nodiscard]] NumberField *editCell(int row, int column) const;
    [[nodiscard]] bool says(const QString &part) const;
    static void type(NumberField *into, const QString &text, int key);
    [[nodiscard]] const Preset &preset() const { return document.preset(); }

    Simulation simulation{inspectedScene()};
    PresetDocument document{simulation};
    Inspector inspector{document};
};

inline bool OpenInspector::show()
{
    inspector.resize(700, 400);
    inspector.show();
    inspector.activateWindow();
    return QTest::qWaitForWindowActive(&inspector, patience);
}

inline NumberField *OpenInspector::field(const QString &name) const
{
    for (auto *each : inspector.findChildren<NumberField *>()) {
        if (each->accessibleName().startsWith(name))
            return each;
    }
    return nullptr;
}

inline QComboBox *OpenInspector::law(const QString &name) const
{
    for (auto *each : inspector.findChildren<QComboBox *>()) {
        if (each->accessibleName() == QStringLiteral("Law: ") + name)
            return each;
    }
    return nullptr;
}

inline QPushButton *OpenInspector::button(const QString &name) const
{
    for (auto *each : inspector.findChildren<QPushButton *>()) {
        if (each->accessibleName() == name)
            return each;
    }
    return nullptr;
}

inline NumberField *OpenInspector::editCell(int row, int column) const
{
    table()->setFocus();
    table()->setCurrentIndex(table()->model()->index(row, column));
    table()->edit(table()->currentIndex());
    return table()->viewport()->findChild<NumberField *>();
}

inline bool OpenInspector::says(const QString &part) const
{
    for (const auto *label : inspector.findChildren<QLabel *>()) {
        if (label->isVisible() && label->text().contains(part))
            return true;
    }
    return false;
}

inline void OpenInspector::type(NumberField *into, const QString &text, int key)
{
    into->setFocus();
    into->selectAll();
    QTest::keyClicks(into, text);
    QTest::keyClick(into, static_cast<Qt::Key>(key));
}

} // namespace cradle
