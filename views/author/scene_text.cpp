// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/scene_text.h"

#include "views/author/form_rows.h"
#include "views/boxes.h"
#include "views/on_change.h"

#include <QLabel>
#include <QPlainTextEdit>
#include <QSignalBlocker>

namespace cradle {

namespace {

const QString textField = QStringLiteral("text");

} // namespace

SceneText::SceneText(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_note(makeMutedText(this))
    , m_text(makeFileText(QStringLiteral("sceneText"), this))
{
    QLabel *reason = makeRefusal(m_texts, this);
    reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
    reason->setObjectName(QStringLiteral("sceneTextReason"));
    m_text->setLayoutDirection(Qt::LeftToRight);
    setFocusProxy(m_text);
    layOutColumn(this, {12, 8, 12, 8}, 8, {m_note, {m_text, 1}, reason});
    keepTranslated(this, &SceneText::retranslate);
    connect(m_text, &QPlainTextEdit::textChanged, this, &SceneText::takeText);
}

void SceneText::showScene(StepPreset which)
{
    m_which = which;
    const Result<QString> path = presetPath(m_document.files(), m_document.step(), which);
    m_path = path ? *path : QString();
    m_text->setReadOnly(m_document.isReadOnly() || m_path.isEmpty());
    const QString written = textOf(m_document.files(), m_path);
    m_texts.setSubject(m_path);
    const RefusedTexts::Text *refused = m_texts.find(textField, written);
    const QString text = refused ? refused->typed : written;
    if (m_text->toPlainText() != text) {
        const QSignalBlocker blocker(m_text);
        m_text->setPlainText(text);
    }
}

void SceneText::takeText()
{
    if (m_path.isEmpty())
        return;
    const LabFiles files = withText(m_document.files(), m_path, m_text->toPlainText());
    const Result<Preset> scene = presetOf(files, m_document.step(), m_which);
    if (!scene) {
        m_texts.keep(textField, {.typed = m_text->toPlainText(),
                                 .value = textOf(m_document.files(), m_path),
                                 .reason = scene.error().toString()});
        return;
    }
    m_texts.drop(textField);
    m_document.edit(tr("Write the scene"), files, QStringLiteral("sceneText:") + m_path);
}

void SceneText::retranslate()
{
    m_note->setText(tr("Numbers may be expressions, in quotes: \"1 + 0.42*cos(pi/6)\", \"20 cm\", "
                       "or with the lab's values, \"-e*v\". What cannot be read stays here and is "
                       "not in the lab yet."));
    m_text->setAccessibleName(tr("The scene as text"));
}

} // namespace cradle
