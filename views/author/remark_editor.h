// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/task_form.h"
#include "views/author/refused_texts.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QComboBox;
class QLabel;
QT_END_NAMESPACE

namespace cradle {

class CirclesLine;
class SceneForm;

/// How a remark is recognised: what is compared with the student's program, of which circles, in
/// which scenes.
class RemarkEditor final : public QWidget
{
    Q_OBJECT
public:
    explicit RemarkEditor(QWidget *parent = nullptr);

    void show(const RemarkForm &remark, const QString &step);
    void setReadOnly(bool readOnly);
    /// What was typed into remarks, "STEP/ID", and is no value.
    [[nodiscard]] RefusedTexts &refusedTexts() { return m_texts; }

signals:
    void edited(const cradle::RemarkForm &remark, const QString &field);

private:
    void makeLayout();
    void wire();
    void retranslate();

    RemarkForm m_remark;
    QString m_step; ///< of the remark
    RefusedTexts m_texts;
    QLabel *m_purpose = nullptr;
    QComboBox *m_compare = nullptr;
    CirclesLine *m_circles = nullptr;
    SceneForm *m_scene = nullptr;
};

} // namespace cradle
