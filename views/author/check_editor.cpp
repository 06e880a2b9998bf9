// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/check_editor.h"

#include "model/shortest_number.h"
#include "tasks/checks/check_kinds.h"
#include "views/author/parameter_form.h"
#include "views/theme.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>

namespace cradle {

namespace {

constexpr int shortWidth = 190; ///< px
constexpr double mostPoints = 1000.0;

QLabel *mutedText(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setWordWrap(true);
    setKind(label, "muted");
    return label;
}

QFormLayout *makeForm()
{
    auto *form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    return form;
}

QString circlesText(const std::vector<int> &circles)
{
    QStringList numbers;
    for (const int circle : circles)
        numbers.append(QString::number(circle + 1));
    return numbers.join(QStringLiteral(", "));
}

} // namespace

CheckEditor::CheckEditor(QWidget *parent)
    : QWidget(parent)
{
    makeLayout();
    fillKinds();
    retranslate();
    wire();
}

void CheckEditor::makeLayout()
{
    m_heading = new QLabel(this);
    m_sceneHeading = new QLabel(this);
    for (QLabel *heading : {m_heading, m_sceneHeading}) {
        heading->setFont(headingFont());
        setKind(heading, "heading");
    }
    m_title = new QLineEdit(this);
    m_id = new QLineEdit(this);
    m_kind = new QComboBox(this);
    m_purpose = mutedText(this);
    m_circles = new QLineEdit(this);
    m_points = new QLineEdit(this);
    m_parameters = new ParameterForm(this);
    m_scene = new QComboBox(this);
    m_scenePurpose = mutedText(this);
    m_sceneForm = new ParameterForm(this);
    m_refusal = new QLabel(this);
    m_refusal->setWordWrap(true);
    setKind(m_refusal, "warning");
    m_refusal->hide();
    m_title->setObjectName(QStringLiteral("checkTitle"));
    m_id->setObjectName(QStringLiteral("checkId"));
    m_kind->setObjectName(QStringLiteral("checkKind"));
    m_scene->setObjectName(QStringLiteral("sceneKind"));
    m_circles->setObjectName(QStringLiteral("checkCircles"));
    m_points->setObjectName(QStringLiteral("checkPoints"));
    for (QLineEdit *line : {m_id, m_circles, m_points})
        line->setMaximumWidth(shortWidth);
    for (QComboBox *list : {m_kind, m_scene})
        list->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);

    QFormLayout *top = makeForm();
    QFormLayout *bottom = makeForm();
    QWidget *const fields[] = {m_title, m_id, m_points, m_kind, m_circles, m_scene};
    for (std::size_t i = 0; i < std::size(fields); ++i) {
        m_captions[i] = new QLabel(this);
        m_captions[i]->setBuddy(fields[i]);
        m_captions[i]->setMinimumWidth(m_parameters->captionWidth());
        (fields[i] == m_scene ? bottom : top)->addRow(m_captions[i], fields[i]);
        if (fields[i] == m_kind)
            top->addRow(m_purpose);
    }
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 10, 16, 12);
    column->setSpacing(8);
    column->addWidget(m_heading);
    column->addLayout(top);
    column->addWidget(m_parameters);
    column->addSpacing(8);
    column->addWidget(m_sceneHeading);
    column->addLayout(bottom);
    column->addWidget(m_scenePurpose);
    column->addWidget(m_sceneForm);
    column->addWidget(m_refusal);
    column->addStretch(1);
}

void CheckEditor::wire()
{
    connect(m_title, &QLineEdit::textEdited, this, [this](const QString &text) {
        m_check.title = text;
        emit edited(m_check, QStringLiteral("title"));
    });
    connect(m_id, &QLineEdit::editingFinished, this, [this] {
        static const QRegularExpression form(QStringLiteral("^[A-Za-z0-9._-]{1,64}$"));
        const QString id = m_id->text().trimmed();
        if (!form.match(id).hasMatch()) {
            m_id->setText(m_check.id);
            showRefusal(tr("An id of letters, digits, dots and dashes is right"));
            return;
        }
        m_check.id = id;
        emit edited(m_check, QStringLiteral("id"));
    });
    connect(m_circles, &QLineEdit::editingFinished, this, &CheckEditor::takeCircles);
    connect(m_points, &QLineEdit::editingFinished, this, &CheckEditor::takePoints);
    connect(m_kind, &QComboBox::activated, this, [this] {
        m_check.kind = m_kind->currentData().toString();
        m_check.parameters = {}; // those of another kind mean nothing here
        showKind();
        emit edited(m_check, QStringLiteral("kind"));
    });
    connect(m_scene, &QComboBox::activated, this, [this] {
        m_check.scene = {{QStringLiteral("kind"), m_scene->currentData().toString()}};
        showKind();
        emit edited(m_check, QStringLiteral("scene"));
    });
    connect(m_parameters, &ParameterForm::edited, this, [this](const QJsonObject &values) {
        m_check.parameters = values;
        emit edited(m_check, QStringLiteral("parameters"));
    });
    connect(m_sceneForm, &ParameterForm::edited, this, [this](const QJsonObject &values) {
        m_check.scene = values;
        emit edited(m_check, QStringLiteral("sceneParameters"));
    });
    connect(m_parameters, &ParameterForm::refused, this, &CheckEditor::showRefusal);
    connect(m_sceneForm, &ParameterForm::refused, this, &CheckEditor::showRefusal);
}

void CheckEditor::show(const CheckForm &check)
{
    m_check = check;
    const std::pair<QLineEdit *, QString> lines[] = {
        {m_title, check.title},
        {m_id, check.id},
        {m_circles, circlesText(check.circles)},
        {m_points, check.points == 1.0 ? QString() : shortestNumber(check.points)}};
    for (const auto &[line, text] : lines) {
        if (line->text() != text)
            line->setText(text);
    }
    m_refusal->hide();
    showKind();
}

void CheckEditor::showKind()
{
    m_kind->setCurrentIndex(m_kind->findData(m_check.kind));
    const std::vector<KindInfo> kinds = checkKinds();
    if (const KindInfo *kind = findKind(kinds, m_check.kind)) {
        m_purpose->setText(kind->purpose);
        m_parameters->show(*kind, m_check.parameters);
    }
    const QString scene =
        m_check.scene.value(QStringLiteral("kind")).toString(QStringLiteral("own"));
    m_scene->setCurrentIndex(m_scene->findData(scene));
    const std::vector<KindInfo> scenes = sceneKinds();
    if (const KindInfo *kind = findKind(scenes, scene)) {
        m_scenePurpose->setText(kind->purpose);
        m_sceneForm->show(*kind, m_check.scene);
    }
}

void CheckEditor::showRefusal(const QString &reason)
{
    m_refusal->setText(reason);
    m_refusal->setVisible(!reason.isEmpty());
}

void CheckEditor::takeCircles()
{
    std::vector<int> circles;
    static const QRegularExpression between(QStringLiteral("[,;\\s]+"));
    for (const QString &part : m_circles->text().split(between, Qt::SkipEmptyParts)) {
        bool ok = false;
        const int circle = part.toInt(&ok);
        if (!ok || circle < 1 || circle > 100) {
            m_circles->setText(circlesText(m_check.circles));
            showRefusal(tr("Circles: numbers from 1 to 100 as “1, 2” are right"));
            return;
        }
        circles.push_back(circle - 1);
    }
    if (circles == m_check.circles)
        return;
    m_check.circles = circles;
    emit edited(m_check, QStringLiteral("circles"));
}

void CheckEditor::takePoints()
{
    bool ok = true;
    const QString text = m_points->text().trimmed();
    const double points = text.isEmpty() ? 1.0 : text.toDouble(&ok);
    if (!ok || !(points >= 0.0 && points <= mostPoints)) {
        show(m_check);
        showRefusal(tr("Points: a number from 0 to 1000 is right"));
        return;
    }
    if (points == m_check.points)
        return;
    m_check.points = points;
    emit edited(m_check, QStringLiteral("points"));
}

void CheckEditor::setReadOnly(bool readOnly)
{
    for (QLineEdit *line : {m_title, m_id, m_circles, m_points})
        line->setReadOnly(readOnly);
    m_kind->setEnabled(!readOnly);
    m_scene->setEnabled(!readOnly);
    m_parameters->setReadOnly(readOnly);
    m_sceneForm->setReadOnly(readOnly);
}

void CheckEditor::fillKinds()
{
    const std::pair<QComboBox *, std::vector<KindInfo>> lists[] = {{m_kind, checkKinds()},
                                                                   {m_scene, sceneKinds()}};
    for (const auto &[list, kinds] : lists) {
        list->clear();
        for (const KindInfo &kind : kinds) {
            list->addItem(kind.title, kind.name);
            list->setItemData(list->count() - 1, kind.purpose, Qt::ToolTipRole);
        }
    }
}

void CheckEditor::retranslate()
{
    m_heading->setText(tr("What is checked"));
    m_sceneHeading->setText(tr("In which scenes"));
    const QString captions[] = {tr("Title"), tr("Id"),      tr("Points"),
                                tr("Kind"),  tr("Circles"), tr("Scenes")};
    for (std::size_t i = 0; i < std::size(captions); ++i)
        m_captions[i]->setText(captions[i]);
    m_title->setAccessibleName(tr("Title of the check"));
    m_id->setAccessibleName(tr("Id of the check"));
    m_id->setToolTip(tr("Letters, digits, dots and dashes; reports name the check by it"));
    m_points->setAccessibleName(tr("Points"));
    m_points->setPlaceholderText(QStringLiteral("1"));
    m_points->setToolTip(tr("What passing this check is worth in reports"));
    m_kind->setAccessibleName(tr("Kind of the check"));
    m_circles->setAccessibleName(tr("Circles that it looks at"));
    m_circles->setPlaceholderText(QStringLiteral("1"));
    m_circles->setToolTip(tr("Numbers of the circles, as “1, 2”"));
    m_scene->setAccessibleName(tr("Kind of the scenes"));
}

void CheckEditor::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        fillKinds();
        retranslate();
        showKind();
    }
}

} // namespace cradle
