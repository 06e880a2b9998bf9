// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/arrangement_dialog.h"

#include "views/author/form_rows.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace cradle {

ArrangementDialog::ArrangementDialog(Arrangement::Pattern pattern, QWidget *parent)
    : QDialog(parent)
    , m_pattern(pattern)
    , m_form(makeFormRows())
{
    using Pattern = Arrangement::Pattern;
    const Arrangement usual;
    auto *column = new QVBoxLayout(this);
    column->addLayout(m_form);
    setWindowTitle(nameOf(pattern));
    m_rows = pattern == Pattern::Ring ? addCount(tr("Circles"), "arrangementRows", 8)
                                      : addCount(tr("Rows"), "arrangementRows", usual.rows);
    if (pattern == Pattern::Grid)
        m_columns = addCount(tr("Columns"), "arrangementColumns", usual.columns);
    m_radius = addLength(tr("Radius"), "arrangementRadius", usual.radius, 0.01);
    m_gap = addLength(tr("Gap between rims"), "arrangementGap", usual.gap, 0.0);
    m_striker = new QCheckBox(tr("One more comes from the left"), this);
    m_striker->setObjectName(QStringLiteral("arrangementStriker"));
    m_striker->setChecked(pattern == Pattern::Rack);
    connect(m_striker, &QCheckBox::toggled, this, &ArrangementDialog::showResult);
    column->addWidget(m_striker);
    m_result = new QLabel(this);
    m_result->setObjectName(QStringLiteral("arrangementResult"));
    m_result->setWordWrap(true);
    column->addWidget(m_result);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(m_buttons);
    showResult();
    m_rows->selectAll();
}

QSpinBox *ArrangementDialog::addCount(const QString &caption, const char *name, int value)
{
    auto *field = new QSpinBox(this);
    field->setRange(1, 100);
    field->setValue(value);
    connect(field, &QSpinBox::valueChanged, this, &ArrangementDialog::showResult);
    add(field, caption, name);
    return field;
}

QDoubleSpinBox *ArrangementDialog::addLength(const QString &caption, const char *name, double value,
                                             double least)
{
    auto *field = new QDoubleSpinBox(this);
    field->setRange(least, 2.0);
    field->setDecimals(3);
    field->setSingleStep(0.01);
    field->setSuffix(QStringLiteral(" m"));
    field->setValue(value);
    connect(field, &QDoubleSpinBox::valueChanged, this, &ArrangementDialog::showResult);
    add(field, caption, name);
    return field;
}

void ArrangementDialog::add(QWidget *field, const QString &caption, const char *name)
{
    field->setObjectName(QLatin1String(name));
    addField(m_form, field);
    nameField(field, caption);
}

Arrangement ArrangementDialog::arrangement() const
{
    return {.pattern = m_pattern,
            .rows = m_rows->value(),
            .columns = m_columns ? m_columns->value() : 1,
            .radius = m_radius->value(),
            .gap = m_gap->value(),
            .hasStriker = m_striker->isChecked()};
}

void ArrangementDialog::showResult()
{
    if (!m_buttons)
        return; // while the fields are made
    const Arrangement asked = arrangement();
    const Result<Preset> made = presetOf(asked);
    m_result->setText(made ? tr("%n circle(s)", nullptr, countOf(asked)) : made.error().message);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(made.ok());
}

} // namespace cradle
