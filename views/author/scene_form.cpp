// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/scene_form.h"

#include "tasks/checks/check_kinds.h"
#include "tasks/runs/scene_spec.h"
#include "views/author/form_rows.h"
#include "views/author/parameter_form.h"
#include "views/boxes.h"
#include "views/choice_box.h"
#include "views/on_change.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

namespace cradle {

SceneForm::SceneForm(RefusedTexts &texts, QWidget *parent)
    : QWidget(parent)
    , m_kind(new ChoiceBox(this))
    , m_purpose(makeMutedText(this))
    , m_values(new ParameterForm(texts, QStringLiteral("scene"), this))
{
    m_kind->setObjectName(QStringLiteral("sceneKind"));
    m_kind->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    QFormLayout *top = makeFormRows();
    addField(top, m_kind)->setMinimumWidth(m_values->captionWidth());
    layOutColumn(this, {}, 8, {top, m_purpose, m_values});
    retranslate();
    connect(m_kind, &QComboBox::activated, this, [this] {
        const QString kind = m_kind->currentData().toString();
        if (kind == m_scene.value(QStringLiteral("kind")).toString())
            return;
        showScene({{QStringLiteral("kind"), kind}});
        emit edited(m_scene, QStringLiteral("scene"));
    });
    connect(m_values, &ParameterForm::edited, this, [this](const QJsonObject &values) {
        m_scene = values;
        emit edited(m_scene, QStringLiteral("sceneParameters"));
    });
    onChange(this, {QEvent::LanguageChange}, [this] {
        retranslate();
        showScene(m_scene);
    });
}

void SceneForm::showScene(const QJsonObject &scene)
{
    m_scene = scene;
    const QString name = scene.value(QStringLiteral("kind")).toString(SceneSpec().kind);
    m_kind->setCurrentIndex(m_kind->findData(name));
    const std::vector<KindInfo> ofScenes = sceneKinds();
    if (const KindInfo *kind = findKind(ofScenes, name)) {
        m_purpose->setText(kind->purpose);
        m_values->show(*kind, scene);
    }
}

int SceneForm::captionWidth() const
{
    return m_values->captionWidth();
}

void SceneForm::setReadOnly(bool readOnly)
{
    m_kind->setEnabled(!readOnly);
    m_values->setReadOnly(readOnly);
}

void SceneForm::retranslate()
{
    nameField(m_kind, tr("Kind"), {}, tr("Kind of the scenes"));
    fillKindList(m_kind, sceneKinds());
}

} // namespace cradle
