// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_kinds.h"

#include <QJsonObject>
#include <QWidget>

#include <functional>
#include <vector>

QT_BEGIN_NAMESPACE
class QFormLayout;
class QLineEdit;
QT_END_NAMESPACE

namespace cradle {

/// Fields for the parameters of one kind of check or scene, made from the catalogue. What is left
/// empty is left out of the file; the field then shows what holds.
class ParameterForm final : public QWidget
{
    Q_OBJECT
public:
    explicit ParameterForm(QWidget *parent = nullptr);

    /// Makes the fields of \p kind, if they are not there already, and shows \p values in them.
    void show(const KindInfo &kind, const QJsonObject &values);
    void setReadOnly(bool readOnly);
    /// The field of the parameter with that name, or nullptr.
    [[nodiscard]] QWidget *field(const QString &name) const;
    /// The width of the captions, px, so that two forms can stand in line.
    [[nodiscard]] int captionWidth() const;

signals:
    void edited(const QJsonObject &values);
    void refused(const QString &reason); ///< what was typed is no value; empty: it is one again

private:
    struct Field {
        ParameterInfo info;
        QWidget *widget = nullptr;
        std::function<void(const QJsonValue &)> display;
    };

    void addField(const ParameterInfo &info);
    Field makeFlag(const ParameterInfo &info);
    Field makeChoice(const ParameterInfo &info);
    Field makeChoices(const ParameterInfo &info);
    Field makeLine(const ParameterInfo &info);
    void set(const QString &name, const QJsonValue &value);

    QFormLayout *m_layout;
    QString m_kind;
    std::vector<Field> m_fields;
    QJsonObject m_values;
    bool m_readOnly = false;
};

} // namespace cradle
