// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/task_form.h"
#include "views/author/refused_texts.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QComboBox;
class QLabel;
class QLineEdit;
QT_END_NAMESPACE

namespace cradle {

class CirclesLine;
class ParameterForm;
class SceneForm;

/// One check as a form: what it is called, its kind with its parameters, and the scenes in which
/// it runs. The fields come from the catalogue of kinds.
class CheckEditor final : public QWidget
{
    Q_OBJECT
public:
    explicit CheckEditor(QWidget *parent = nullptr);

    void show(const CheckForm &check, const QString &step);
    void setReadOnly(bool readOnly);
    /// What was typed into checks, "STEP/ID", and is no value.
    [[nodiscard]] RefusedTexts &refusedTexts() { return m_texts; }

signals:
    void edited(const cradle::CheckForm &check, const QString &field);

private:
    void makeLayout();
    void wire();
    void retranslate();
    void showKind();
    void takePoints();
    void takeId();

    CheckForm m_check;
    QString m_step; ///< of the check
    RefusedTexts m_texts;
    QLabel *m_heading = nullptr;
    QLineEdit *m_title = nullptr;
    QLineEdit *m_id = nullptr;
    QComboBox *m_kind = nullptr;
    QLabel *m_purpose = nullptr;
    CirclesLine *m_circles = nullptr;
    QLineEdit *m_points = nullptr;
    ParameterForm *m_parameters = nullptr;
    QLabel *m_sceneHeading = nullptr;
    SceneForm *m_scene = nullptr;
};

} // namespace cradle
