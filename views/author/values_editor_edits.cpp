// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/values_editor.h"

#include "model/files/expression.h"
#include "model/world/shortest_number.h"
#include "tasks/authoring/free_name.h"
#include "tasks/values/lab_values.h"
#include "views/author/form_rows.h"
#include "views/author/rows_list.h"
#include "views/choice_box.h"

#include <QLabel>

#include <algorithm>
#include <span>

namespace cradle {

// What is typed into the form, and where it goes.

namespace {

bool areEmpty(std::span<const QString> texts)
{
    return std::all_of(texts.begin(), texts.end(),
                       [](const QString &text) { return text.isEmpty(); });
}

} // namespace

/// The names of the other values of a step, or of the lab.
QStringList ValuesEditor::taken(const QString &step) const
{
    QStringList names;
    for (const ValueForm &value : valueForms(m_document.files(), step)) {
        if (at() < 0 || step != current().step || value.name != current().value.name)
            names.append(value.name);
    }
    return names;
}

/// The files with \p row in place of the current one, which may stand elsewhere.
Result<LabFiles> ValuesEditor::with(const Row &row) const
{
    const Row &before = current();
    std::vector<ValueForm> old = valueForms(m_document.files(), before.step);
    const auto found = std::find_if(old.begin(), old.end(), [&](const ValueForm &value) {
        return value.name == before.value.name;
    });
    if (found == old.end())
        return m_document.files();
    if (row.step == before.step) {
        *found = row.value;
        return withValueForms(m_document.files(), row.step, old);
    }
    old.erase(found);
    const Result<LabFiles> without = withValueForms(m_document.files(), before.step, old);
    if (!without)
        return without;
    std::vector<ValueForm> there = valueForms(*without, row.step);
    there.push_back(row.value);
    return withValueForms(*without, row.step, there);
}

void ValuesEditor::put(const Row &row, const QString &mergeKey)
{
    const Result<LabFiles> files = with(row);
    const QString before = m_chosen;
    m_chosen = subjectOf(row); // the window answers with reload()
    if (!m_document.edit(tr("Edit a value"), files, mergeKey)) {
        m_chosen = before;
        reload();
    }
}

ValueForm ValuesEditor::typed(QString (&reasons)[LineCount], Line changed) const
{
    ValueForm value = current().value;
    value.name = m_lines[Name]->text().trimmed();
    if (!isValueName(value.name))
        reasons[Name] = tr("A name of letters, digits and underscores that means nothing else, as "
                           "sin does, is right");
    else if (taken(current().step).contains(value.name))
        reasons[Name] = tr("Another value has this name already");
    for (int i = Expression; i < LineCount; ++i) {
        const QString text = m_lines[i]->text().trimmed();
        const Result<double> number = evaluated(text);
        if (!isShown(static_cast<Line>(i)))
            continue;
        if (lines[i].text)
            value.*lines[i].text = text;
        else if (number)
            value.*lines[i].number = *number;
        else
            reasons[i] = number.error().message;
    }
    if (!areEmpty(reasons))
        return value;
    const Result<LabFiles> files = with({current().step, value});
    const Line place = !value.drawn ? Expression : changed == Name ? From : changed;
    reasons[place] =
        files ? faultOfValue(*files, current().step, value.name) : files.error().message;
    return value;
}

/// A value is taken when all its lines are right; until then they stay as they are typed.
void ValuesEditor::takeLines(Line changed)
{
    if (at() < 0)
        return;
    QString reasons[LineCount];
    const ValueForm value = typed(reasons, changed);
    const bool right = areEmpty(reasons);
    for (int i = 0; i < LineCount; ++i) {
        QLineEdit *edit = m_lines[i];
        if (!isShown(static_cast<Line>(i)))
            continue;
        const QString shown = lines[i].textIn(current().value);
        if (!right && (edit->text() != shown || !reasons[i].isEmpty()))
            m_texts.keep(edit->objectName(), {edit->text(), shown, reasons[i]});
        else
            m_texts.drop(edit->objectName());
        markRefused(edit, !reasons[i].isEmpty());
    }
    showRefusal(m_refusal, m_texts.reason());
    if (right && value != current().value)
        put({current().step, value}, QStringLiteral("value:%1:%2").arg(changed).arg(m_typing));
}

void ValuesEditor::takeKind()
{
    const bool drawn = m_kind->currentIndex() == 1;
    if (at() < 0 || drawn == current().value.drawn)
        return;
    Row row = current();
    m_texts.forget(m_chosen);
    row.value.drawn = drawn;
    if (drawn) {
        row.value.from = valuesOf(m_document.files(), row.step, {}).value(row.value.name);
        row.value.to = row.value.from + 1.0;
        row.value.step = 0.1;
    } else {
        row.value.expression = shortestNumber(row.value.from);
    }
    put(row, {});
}

void ValuesEditor::takePlace()
{
    if (at() < 0)
        return;
    Row row = current();
    row.step = m_place->currentIndex() == 0 ? QString() : m_document.step();
    if (row.step == current().step)
        return;
    if (const std::vector<ValueForm> there = valueForms(m_document.files(), row.step);
        std::any_of(there.begin(), there.end(),
                    [&](const ValueForm &value) { return value.name == row.value.name; })) {
        m_place->setCurrentIndex(current().step.isEmpty() ? 0 : 1);
        showRefusal(m_refusal, tr("There is a value %1 already").arg(row.value.name));
        return;
    }
    m_texts.rename(subjectOf(row));
    put(row, {});
}

void ValuesEditor::takeDraw()
{
    m_document.edit(tr("Edit the draw"), withDraw(m_document.files(), m_draw->text()),
                    QStringLiteral("draw"));
}

/// A new value of the step: 1, until something else is typed.
void ValuesEditor::add()
{
    std::vector<ValueForm> values = valueForms(m_document.files(), m_document.step());
    const auto isTaken = [&](const QString &name) {
        return std::any_of(values.begin(), values.end(),
                           [&](const ValueForm &value) { return value.name == name; });
    };
    const QString name = freeName(QStringLiteral("value"), isTaken, {});
    values.push_back({.name = name, .expression = QStringLiteral("1")});
    m_chosen = m_document.inStep(name);
    ++m_typing;
    if (!m_document.edit(tr("Add a value"),
                         withValueForms(m_document.files(), m_document.step(), values)))
        return;
    writeName();
}

void ValuesEditor::writeName()
{
    m_lines[Name]->setFocus();
    m_lines[Name]->selectAll();
}

void ValuesEditor::remove()
{
    const Row row = current();
    std::vector<ValueForm> values = valueForms(m_document.files(), row.step);
    values.erase(
        std::remove_if(values.begin(), values.end(),
                       [&](const ValueForm &value) { return value.name == row.value.name; }),
        values.end());
    const int before = at();
    m_texts.forget(m_chosen);
    if (m_document.edit(tr("Remove a value"), withValueForms(m_document.files(), row.step, values)))
        m_list->setCurrentRow(std::min(before, m_list->count() - 1));
}

} // namespace cradle
