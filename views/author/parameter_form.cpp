// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/parameter_form.h"

#include "views/author/form_rows.h"
#include "views/author/parameter_text.h"
#include "views/boxes.h"
#include "views/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace cradle {

namespace {

using Type = ParameterInfo::Type;

constexpr int fieldWidth = 190; ///< px

} // namespace

ParameterForm::ParameterForm(RefusedTexts &texts, const QString &name, QWidget *parent)
    : QWidget(parent)
    , m_texts(texts)
    , m_name(name)
    , m_layout(makeFormRows())
{
    setLayout(m_layout);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
}

void ParameterForm::show(const KindInfo &kind, const QJsonObject &values)
{
    // The labels are in the language in which they were made.
    const QString made = kind.name + kind.title;
    m_kindName = kind.name;
    if (made != m_kind) {
        m_kind = made;
        while (m_layout->rowCount() > 0)
            m_layout->removeRow(0);
        m_fields.clear();
        for (const ParameterInfo &info : kind.parameters)
            addField(info);
        setReadOnly(m_readOnly);
    }
    m_values = values;
    for (const Field &field : m_fields)
        field.display(values.value(field.info.name));
}

void ParameterForm::setReadOnly(bool readOnly)
{
    m_readOnly = readOnly;
    for (const Field &field : m_fields)
        field.widget->setEnabled(!readOnly);
}

QWidget *ParameterForm::field(const QString &name) const
{
    const auto found = std::find_if(m_fields.begin(), m_fields.end(),
                                    [&](const Field &field) { return field.info.name == name; });
    return found == m_fields.end() ? nullptr : found->widget;
}

void ParameterForm::addField(const ParameterInfo &info)
{
    Field field;
    if (info.type == Type::Flag)
        field = makeFlag(info);
    else if (info.type == Type::Choice)
        field = makeChoice(info);
    else if (info.type == Type::Choices)
        field = makeChoices(info);
    else
        field = makeLine(info);
    field.widget->setObjectName(info.name);
    field.widget->setToolTip(info.help);
    auto *caption = new QLabel(info.required ? info.label + QStringLiteral(" *") : info.label);
    caption->setToolTip(info.help);
    caption->setMinimumWidth(captionWidth());
    caption->setBuddy(field.widget);
    auto *row = new QWidget(this);
    auto *unit = new QLabel(info.unit, row);
    unit->setHidden(info.unit.isEmpty());
    setKind(unit, "muted");
    layOutRow(row, {}, -1, {field.widget, unit, BoxPart::rest()});
    m_layout->addRow(caption, row);
    m_fields.push_back(std::move(field));
}

int ParameterForm::captionWidth() const
{
    return fontMetrics().averageCharWidth() * 22;
}

void ParameterForm::set(const QString &name, const QJsonValue &value)
{
    QJsonObject values = m_values;
    if (value.isUndefined())
        values.remove(name);
    else
        values.insert(name, value);
    if (values != m_values)
        emit edited(values);
}

ParameterForm::Field ParameterForm::makeFlag(const ParameterInfo &info)
{
    auto *box = new QCheckBox(this);
    box->setAccessibleName(info.label);
    const bool standard = info.standard.toBool();
    connect(box, &QCheckBox::clicked, this, [this, info, standard](bool on) {
        set(info.name, on == standard ? QJsonValue(QJsonValue::Undefined) : QJsonValue(on));
    });
    return {info, box,
            [box, standard](const QJsonValue &value) { box->setChecked(value.toBool(standard)); }};
}

ParameterForm::Field ParameterForm::makeChoice(const ParameterInfo &info)
{
    auto *list = new QComboBox(this);
    list->setAccessibleName(info.label);
    if (!info.required)
        list->addItem(info.standard.isUndefined() ? tr("left out")
                                                  : tr("%1 (usual)").arg(info.standard.toString()));
    for (const QString &choice : info.choices)
        list->addItem(choice, choice);
    connect(list, &QComboBox::activated, this, [this, info, list] {
        const QString choice = list->currentData().toString();
        set(info.name, choice.isEmpty() ? QJsonValue(QJsonValue::Undefined) : QJsonValue(choice));
    });
    return {info, list, [list](const QJsonValue &value) {
                list->setCurrentIndex(value.isString() ? list->findData(value.toString()) : 0);
            }};
}

ParameterForm::Field ParameterForm::makeChoices(const ParameterInfo &info)
{
    auto *group = new QWidget(this);
    auto *row = layOutColumn(group, {}, 2);
    std::vector<QCheckBox *> boxes;
    for (const QString &choice : info.choices) {
        auto *box = new QCheckBox(choice, group);
        box->setObjectName(info.name + QLatin1Char('.') + choice);
        boxes.push_back(box);
        row->addWidget(box);
    }
    for (QCheckBox *box : boxes) {
        connect(box, &QCheckBox::clicked, this, [this, info, boxes, box] {
            QJsonArray chosen;
            for (const QCheckBox *each : boxes) {
                if (each->isChecked())
                    chosen.append(each->text());
            }
            if (chosen.isEmpty())
                box->setChecked(true); // at least one
            else
                set(info.name, chosen == info.standard.toArray() ? QJsonValue(QJsonValue::Undefined)
                                                                 : QJsonValue(chosen));
        });
    }
    return {info, group, [boxes, info](const QJsonValue &value) {
                const QJsonArray chosen =
                    value.isArray() ? value.toArray() : info.standard.toArray();
                for (QCheckBox *box : boxes)
                    box->setChecked(chosen.contains(box->text()));
            }};
}

ParameterForm::Field ParameterForm::makeLine(const ParameterInfo &info)
{
    auto *line = new QLineEdit(this);
    line->setAccessibleName(
        info.unit.isEmpty() ? info.label : QStringLiteral("%1, %2").arg(info.label, info.unit));
    line->setFixedWidth(fieldWidth);
    line->setPlaceholderText(info.standard.isUndefined() ? QString()
                                                         : textOfParameter(info, info.standard));
    connect(line, &QLineEdit::textEdited, this, [this, info, line] { takeLine(info, line); });
    return {info, line,
            [this, line, info](const QJsonValue &value) { showLine(info, line, value); }};
}

void ParameterForm::takeLine(const ParameterInfo &info, QLineEdit *line)
{
    const Result<QJsonValue> value = parameterFromText(info, line->text());
    if (value)
        m_texts.drop(keyOf(info));
    else
        m_texts.keep(keyOf(info), {line->text(), textOfParameter(info, m_values.value(info.name)),
                                   value.error().message});
    markRefused(line, !value);
    if (value)
        set(info.name, *value);
}

void ParameterForm::showLine(const ParameterInfo &info, QLineEdit *line, const QJsonValue &value)
{
    const QString text = textOfParameter(info, value);
    const RefusedTexts::Text *refused = m_texts.find(keyOf(info), text);
    markRefused(line, refused != nullptr);
    // What is being typed stays as it is typed.
    const Result<QJsonValue> typed = parameterFromText(info, line->text());
    if (refused ? line->text() != refused->typed : !typed || *typed != value)
        line->setText(refused ? refused->typed : text);
}

QString ParameterForm::keyOf(const ParameterInfo &info) const
{
    return QStringLiteral("%1/%2/%3").arg(m_name, m_kindName, info.name);
}

} // namespace cradle
