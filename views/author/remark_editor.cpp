// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/remark_editor.h"

#include "views/author/circles_line.h"
#include "views/author/form_rows.h"
#include "views/author/scene_form.h"
#include "views/on_change.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

namespace cradle {

namespace {

constexpr int remarkWidth = 190; ///< px

} // namespace

RemarkEditor::RemarkEditor(QWidget *parent)
    : QWidget(parent)
{
    makeLayout();
    retranslate();
    wire();
    onChange(this, {QEvent::LanguageChange}, [this] {
        retranslate();
        show(m_remark, m_step);
    });
}

void RemarkEditor::makeLayout()
{
    m_purpose = makeMutedText(this);
    m_compareCaption = new QLabel(this);
    m_compare = new QComboBox(this);
    m_circlesCaption = new QLabel(this);
    m_circles = new CirclesLine(m_texts, this);
    m_scene = new SceneForm(m_texts, this);
    m_refusal = makeRefusal(this);
    m_compare->setObjectName(QStringLiteral("remarkCompare"));
    m_circles->setObjectName(QStringLiteral("remarkCircles"));
    m_compare->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    m_circles->setMaximumWidth(remarkWidth);
    QFormLayout *form = makeFormRows();
    const std::pair<QLabel *, QWidget *> rows[] = {{m_compareCaption, m_compare},
                                                   {m_circlesCaption, m_circles}};
    for (const auto &[caption, field] : rows) {
        caption->setBuddy(field);
        caption->setMinimumWidth(m_scene->captionWidth());
        form->addRow(caption, field);
    }
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(8);
    column->addWidget(m_purpose);
    column->addLayout(form);
    column->addWidget(m_scene);
    column->addWidget(m_refusal);
    column->addStretch(1);
}

void RemarkEditor::wire()
{
    connect(m_compare, &QComboBox::activated, this, [this] {
        m_remark.compare = m_compare->currentData().toString();
        emit edited(m_remark, QStringLiteral("compare"));
    });
    connect(m_circles, &CirclesLine::circlesEdited, this, [this](const std::vector<int> &circles) {
        m_remark.circles = circles;
        emit edited(m_remark, QStringLiteral("circles"));
    });
    connect(m_scene, &SceneForm::kindEdited, this, [this](const QJsonObject &scene) {
        m_remark.scene = scene;
        emit edited(m_remark, QStringLiteral("scene"));
    });
    connect(m_scene, &SceneForm::valuesEdited, this, [this](const QJsonObject &scene) {
        m_remark.scene = scene;
        emit edited(m_remark, QStringLiteral("sceneParameters"));
    });
    const auto refuse = [this] { showRefusal(m_refusal, m_texts.reason()); };
    connect(m_circles, &CirclesLine::refusalsChanged, this, refuse);
    connect(m_scene, &SceneForm::refusalsChanged, this, refuse);
}

void RemarkEditor::show(const RemarkForm &remark, const QString &step)
{
    m_remark = remark;
    m_step = step;
    m_texts.setSubject(step + QLatin1Char('/') + remark.id);
    m_compare->setCurrentIndex(m_compare->findData(remark.compare));
    m_circles->showCircles(remark.circles);
    m_scene->showScene(remark.scene);
    showRefusal(m_refusal, m_texts.reason());
}

void RemarkEditor::setReadOnly(bool readOnly)
{
    m_compare->setEnabled(!readOnly);
    m_circles->setReadOnly(readOnly);
    m_scene->setReadOnly(readOnly);
}

void RemarkEditor::retranslate()
{
    m_purpose->setText(tr("A student's program that passes is run beside this one and beside the "
                          "solution. Where these two differ and the student's does as this one, "
                          "the remark is made."));
    m_compareCaption->setText(tr("Compare"));
    m_circlesCaption->setText(tr("Circles"));
    m_compare->setAccessibleName(tr("What is compared"));
    m_compare->clear();
    m_compare->addItem(tr("Velocities: they differ at a hit"), QStringLiteral("velocities"));
    m_compare->addItem(tr("Positions: they differ in many steps"), QStringLiteral("positions"));
    m_compare->addItem(tr("Fields: numbers that the program keeps with the circles, as mass"),
                       QStringLiteral("fields"));
    m_circles->retranslate();
}

} // namespace cradle
