// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QWidget>

QT_BEGIN_NAMESPACE
class QComboBox;
class QLabel;
QT_END_NAMESPACE

namespace cradle {

class ParameterForm;
class RefusedTexts;

/// In which scenes a check or a remark looks: a kind of the catalogue with its parameters.
class SceneForm final : public QWidget
{
    Q_OBJECT
public:
    /// \param texts  keeps what is typed and is no value
    SceneForm(RefusedTexts &texts, QWidget *parent);

    void showScene(const QJsonObject &scene); ///< as it stands in task.json
    void setReadOnly(bool readOnly);
    /// The width of the captions, px, so that a form above can stand in line.
    [[nodiscard]] int captionWidth() const;

signals:
    /// \param field  "scene" if it is another kind, "sceneParameters" else
    void edited(const QJsonObject &scene, const QString &field);

private:
    void retranslate();

    QJsonObject m_scene;
    QComboBox *m_kind = nullptr;
    QLabel *m_purpose = nullptr;
    ParameterForm *m_values = nullptr;
};

} // namespace cradle
