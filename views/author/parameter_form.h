// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_kinds.h"
#include "views/author/refused_texts.h"

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
    /// \param texts  keeps what is typed and is no value
    /// \param name   of the form among those with the same \p texts
    ParameterForm(RefusedTexts &texts, const QString &name, QWidget *parent);

    /// Makes the fields of \p kind, if they are not there already, and shows \p values in them.
    void show(const KindInfo &kind, const QJsonObject &values);
    void setReadOnly(bool readOnly);
    /// The field of the parameter with that name, or nullptr.
    [[nodiscard]] QWidget *field(const QString &name) const;
    /// The width of the captions, px, so that two forms can stand in line.
    [[nodiscard]] int captionWidth() const;

signals:
    void edited(const QJsonObject &values);

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
    void takeLine(const ParameterInfo &info, QLineEdit *line);
    void showLine(const ParameterInfo &info, QLineEdit *line, const QJsonValue &value);
    [[nodiscard]] QString keyOf(const ParameterInfo &info) const; ///< of its text in m_texts

    RefusedTexts &m_texts;
    QString m_name;
    QFormLayout *m_layout;
    QString m_kind;     ///< with the language of its fields
    QString m_kindName; ///< of the catalogue
    std::vector<Field> m_fields;
    QJsonObject m_values;
    bool m_readOnly = false;
};

} // namespace cradle
