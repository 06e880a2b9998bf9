// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/remark_editor.h"

#include "views/author/circles_line.h"
#include "views/author/form_rows.h"
#include "views/author/scene_form.h"
#include "views/boxes.h"
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
    m_compare = new QComboBox(this);
    m_circles = new CirclesLine(m_texts, this);
    m_scene = new SceneForm(m_texts, this);
    m_compare->setObjectName(QStringLiteral("remarkCompare"));
    m_circles->setObjectName(QStringLiteral("remarkCircles"));
    m_compare->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    m_circles->setMaximumWidth(remarkWidth);
    QFormLayout *form = makeFormRows();
    addField(form, m_compare)->setMinimumWidth(m_scene->captionWidth());
    addField(form, m_circles)->setMinimumWidth(m_scene->captionWidth());
    layOutColumn(this, {12, 8, 12, 8}, 8,
                 {m_purpose, form, m_scene, makeRefusal(m_texts, this), BoxPart::rest()});
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
    connect(m_scene, &SceneForm::edited, this,
            [this](const QJsonObject &scene, const QString &field) {
                m_remark.scene = scene;
                emit edited(m_remark, field);
            });
}

void RemarkEditor::show(const RemarkForm &remark, const QString &step)
{
    m_remark = remark;
    m_step = step;
    m_texts.setSubject(step + QLatin1Char('/') + remark.id);
    m_compare->setCurrentIndex(m_compare->findData(remark.compare));
    m_circles->showCircles(remark.circles);
    m_scene->showScene(remark.scene);
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
    nameField(m_compare, tr("Compare"), {}, tr("What is compared"));
    m_compare->clear();
    m_compare->addItem(tr("Velocities: they differ at a hit"), QStringLiteral("velocities"));
    m_compare->addItem(tr("Positions: they differ in many steps"), QStringLiteral("positions"));
    m_compare->addItem(tr("Fields: numbers that the program keeps with the circles, as mass"),
                       QStringLiteral("fields"));
    m_circles->retranslate();
}

} // namespace cradle
