// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/check_editor.h"

#include "model/world/shortest_number.h"
#include "tasks/checks/check_kinds.h"
#include "views/author/circles_line.h"
#include "views/author/form_rows.h"
#include "views/author/parameter_form.h"
#include "views/author/rows_list.h"
#include "views/author/scene_form.h"
#include "views/choice_box.h"
#include "views/on_change.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>

namespace cradle {

namespace {

constexpr int shortWidth = 190; ///< px
constexpr double mostCheckPoints = 1000.0;

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
    m_refusal = makeRefusal(this);
    m_title->setObjectName(QStringLiteral("checkTitle"));
    m_id->setObjectName(QStringLiteral("checkId"));
    m_kind->setObjectName(QStringLiteral("checkKind"));
    m_circles->setObjectName(QStringLiteral("checkCircles"));
    m_points->setObjectName(QStringLiteral("checkPoints"));
    for (QLineEdit *line : {m_id, static_cast<QLineEdit *>(m_circles), m_points})
        line->setMaximumWidth(shortWidth);
    m_kind->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);

    QFormLayout *form = makeFormRows();
    QWidget *const fields[] = {m_title, m_id, m_points, m_kind, m_circles};
    for (std::size_t i = 0; i < std::size(fields); ++i) {
        m_captions[i] = new QLabel(this);
        m_captions[i]->setBuddy(fields[i]);
        m_captions[i]->setMinimumWidth(m_parameters->captionWidth());
        form->addRow(m_captions[i], fields[i]);
        if (fields[i] == m_kind)
            form->addRow(m_purpose);
    }
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 10, 16, 12);
    column->setSpacing(8);
    column->addWidget(m_heading);
    column->addLayout(form);
    column->addWidget(m_parameters);
    column->addSpacing(8);
    column->addWidget(m_sceneHeading);
    column->addWidget(m_scene);
    column->addWidget(m_refusal);
    column->addStretch(1);
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
    connect(m_scene, &SceneForm::kindEdited, this, [this](const QJsonObject &scene) {
        m_check.scene = scene;
        emit edited(m_check, QStringLiteral("scene"));
    });
    connect(m_scene, &SceneForm::valuesEdited, this, [this](const QJsonObject &scene) {
        m_check.scene = scene;
        emit edited(m_check, QStringLiteral("sceneParameters"));
    });
    connect(m_circles, &CirclesLine::refusalsChanged, this, &CheckEditor::showRefusals);
    connect(m_parameters, &ParameterForm::refusalsChanged, this, &CheckEditor::showRefusals);
    connect(m_scene, &SceneForm::refusalsChanged, this, &CheckEditor::showRefusals);
}

void CheckEditor::show(const CheckForm &check, const QString &step)
{
    m_check = check;
    m_step = step;
    m_texts.setSubject(step + QLatin1Char('/') + check.id);
    if (m_title->text() != check.title)
        m_title->setText(check.title);
    showLine(m_id, check.id);
    showLine(m_points, pointsText());
    m_circles->showCircles(check.circles);
    m_scene->showScene(check.scene);
    showKind();
    showRefusals();
}

/// Shows the value of a field that is taken when it is left, or what was typed and is no value.
void CheckEditor::showLine(QLineEdit *line, const QString &value)
{
    const RefusedTexts::Text *refused = m_texts.find(line->objectName(), value);
    const QString text = refused ? refused->typed : value;
    if (line->text() != text)
        line->setText(text);
    markRefused(line, refused != nullptr);
}

void CheckEditor::refuse(QLineEdit *line, const QString &value, const QString &reason)
{
    m_texts.keep(line->objectName(), {line->text(), value, reason});
    markRefused(line, true);
    showRefusals();
}

void CheckEditor::accept(QLineEdit *line)
{
    m_texts.drop(line->objectName());
    markRefused(line, false);
    showRefusals();
}

void CheckEditor::showRefusals()
{
    showRefusal(m_refusal, m_texts.reason());
    emit refusalsChanged();
}

QString CheckEditor::pointsText() const
{
    return m_check.points == 1.0 ? QString() : fractionOrNumber(m_check.points);
}

void CheckEditor::takeId()
{
    static const QRegularExpression form(QStringLiteral("^[A-Za-z0-9._-]{1,64}$"));
    const QString id = m_id->text().trimmed();
    if (!form.match(id).hasMatch()) {
        refuse(m_id, m_check.id,
               tr("An id of letters, digits, dots, dashes and underscores is right"));
        return;
    }
    accept(m_id);
    if (id == m_check.id)
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
    bool ok = true;
    const QString text = m_points->text().trimmed();
    const double points = text.isEmpty() ? 1.0 : text.toDouble(&ok);
    if (!ok || !(points >= 0.0 && points <= mostCheckPoints)) {
        refuse(m_points, pointsText(), tr("Points: a number from 0 to 1000 is right"));
        return;
    }
    accept(m_points);
    if (points == m_check.points)
        return;
    m_check.points = points;
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
    const QString captions[] = {tr("Title"), tr("Id"), tr("Points"), tr("Kind"), tr("Circles")};
    for (std::size_t i = 0; i < std::size(captions); ++i)
        m_captions[i]->setText(captions[i]);
    m_title->setAccessibleName(tr("Title of the check"));
    m_id->setAccessibleName(tr("Id of the check"));
    m_id->setToolTip(tr("Letters, digits, dots and dashes; reports name the check by it"));
    m_points->setAccessibleName(tr("Points"));
    m_points->setPlaceholderText(QStringLiteral("1"));
    m_points->setToolTip(tr("What passing this check is worth in reports"));
    m_kind->setAccessibleName(tr("Kind of the check"));
    fillKindList(m_kind, checkKinds());
    m_circles->retranslate();
}

} // namespace cradle
