// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/check_editor.h"

#include "tasks/checks/check_kinds.h"
#include "views/author/circles_line.h"
#include "views/author/form_rows.h"
#include "views/author/parameter_form.h"
#include "views/author/rows_list.h"
#include "views/author/scene_form.h"
#include "views/boxes.h"
#include "views/choice_box.h"
#include "views/on_change.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

namespace cradle {

namespace {

constexpr int shortWidth = 190; ///< px

} // namespace

CheckEditor::CheckEditor(QWidget *parent)
    : QWidget(parent)
{
    makeLayout();
    retranslate();
    wire();
    onChange(this, {QEvent::LanguageChange}, [this] {
        retranslate();
        showKind();
    });
}

void CheckEditor::makeLayout()
{
    m_heading = makeHeading(this);
    m_sceneHeading = makeHeading(this);
    m_title = new QLineEdit(this);
    m_id = new QLineEdit(this);
    m_kind = new ChoiceBox(this);
    m_purpose = makeMutedText(this);
    m_circles = new CirclesLine(m_texts, this);
    m_points = new QLineEdit(this);
    m_parameters = new ParameterForm(m_texts, QStringLiteral("parameters"), this);
    m_scene = new SceneForm(m_texts, this);
    m_title->setObjectName(QStringLiteral("checkTitle"));
    m_id->setObjectName(QStringLiteral("checkId"));
    m_kind->setObjectName(QStringLiteral("checkKind"));
    m_circles->setObjectName(QStringLiteral("checkCircles"));
    m_points->setObjectName(QStringLiteral("checkPoints"));
    m_points->setPlaceholderText(QStringLiteral("1"));
    for (QLineEdit *line : {m_id, static_cast<QLineEdit *>(m_circles), m_points})
        line->setMaximumWidth(shortWidth);
    m_kind->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);

    QFormLayout *form = makeFormRows();
    for (QWidget *field :
         std::initializer_list<QWidget *>{m_title, m_id, m_points, m_kind, m_circles}) {
        addField(form, field)->setMinimumWidth(m_parameters->captionWidth());
        if (field == m_kind)
            form->addRow(m_purpose);
    }
    layOutColumn(this, {16, 10, 16, 12}, 8,
                 {m_heading, form, m_parameters, BoxPart::space(8), m_sceneHeading, m_scene,
                  makeRefusal(m_texts, this), BoxPart::rest()});
}

void CheckEditor::wire()
{
    connect(m_title, &QLineEdit::textEdited, this, [this](const QString &text) {
        m_check.title = text;
        emit edited(m_check, QStringLiteral("title"));
    });
    connect(m_id, &QLineEdit::editingFinished, this, &CheckEditor::takeId);
    connect(m_circles, &CirclesLine::circlesEdited, this, [this](const std::vector<int> &circles) {
        m_check.circles = circles;
        emit edited(m_check, QStringLiteral("circles"));
    });
    connect(m_points, &QLineEdit::editingFinished, this, &CheckEditor::takePoints);
    connect(m_kind, &QComboBox::activated, this, [this] {
        const QString kind = m_kind->currentData().toString();
        if (kind == m_check.kind)
            return;
        m_check.kind = kind;
        m_check.parameters = {}; // those of another kind mean nothing here
        showKind();
        emit edited(m_check, QStringLiteral("kind"));
    });
    connect(m_parameters, &ParameterForm::edited, this, [this](const QJsonObject &values) {
        m_check.parameters = values;
        emit edited(m_check, QStringLiteral("parameters"));
    });
    connect(m_scene, &SceneForm::edited, this,
            [this](const QJsonObject &scene, const QString &field) {
                m_check.scene = scene;
                emit edited(m_check, field);
            });
}

void CheckEditor::show(const CheckForm &check, const QString &step)
{
    m_check = check;
    m_step = step;
    m_texts.setSubject(step + QLatin1Char('/') + check.id);
    if (m_title->text() != check.title)
        m_title->setText(check.title);
    m_texts.show(m_id, check.id);
    m_texts.show(m_points, pointsText(check.points));
    m_circles->showCircles(check.circles);
    m_scene->showScene(check.scene);
    showKind();
}

void CheckEditor::takeId()
{
    const QString id = m_id->text().trimmed();
    const QString fault = faultOfId(id);
    m_texts.judge(m_id, m_check.id, fault);
    if (!fault.isEmpty() || id == m_check.id)
        return;
    m_texts.rename(m_step + QLatin1Char('/') + id);
    m_check.id = id;
    emit edited(m_check, QStringLiteral("id"));
}

void CheckEditor::showKind()
{
    m_kind->setCurrentIndex(m_kind->findData(m_check.kind));
    const std::vector<KindInfo> kinds = checkKinds();
    if (const KindInfo *kind = findKind(kinds, m_check.kind)) {
        m_purpose->setText(kind->purpose);
        m_parameters->show(*kind, m_check.parameters);
    }
}

void CheckEditor::takePoints()
{
    const Result<double> points = pointsFrom(m_points->text());
    m_texts.judge(m_points, pointsText(m_check.points),
                  points ? QString() : points.error().message);
    if (!points || *points == m_check.points)
        return;
    m_check.points = *points;
    emit edited(m_check, QStringLiteral("points"));
}

void CheckEditor::setReadOnly(bool readOnly)
{
    for (QLineEdit *line : {m_title, m_id, static_cast<QLineEdit *>(m_circles), m_points})
        line->setReadOnly(readOnly);
    m_kind->setEnabled(!readOnly);
    m_parameters->setReadOnly(readOnly);
    m_scene->setReadOnly(readOnly);
}

void CheckEditor::retranslate()
{
    m_heading->setText(tr("What is checked"));
    m_sceneHeading->setText(tr("In which scenes"));
    nameField(m_title, tr("Title"), {}, tr("Title of the check"));
    nameField(m_id, tr("Id"), tr("Letters, digits, dots and dashes; reports name the check by it"),
              tr("Id of the check"));
    nameField(m_points, tr("Points"), tr("What passing this check is worth in reports"));
    nameField(m_kind, tr("Kind"), {}, tr("Kind of the check"));
    fillKindList(m_kind, checkKinds());
    m_circles->retranslate();
}

} // namespace cradle
