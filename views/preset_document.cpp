// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/preset_document.h"

#include "tasks/script/locks.h"

#include <QUndoCommand>

#include <utility>

namespace cradle {

/// One undo step: the preset before and after.
class PresetEdit final : public QUndoCommand
{
public:
    PresetEdit(PresetDocument &document, const QString &text, Preset after, QString mergeKey)
        : QUndoCommand(text)
        , m_document(document)
        , m_before(document.preset())
        , m_after(std::move(after))
        , m_mergeKey(std::move(mergeKey))
    {
    }

    void undo() override { m_document.apply(m_before); }
    void redo() override { m_document.apply(m_after); }
    [[nodiscard]] int id() const override { return m_mergeKey.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand *other) override
    {
        const auto *next = static_cast<const PresetEdit *>(other);
        if (next->m_mergeKey != m_mergeKey)
            return false;
        m_after = next->m_after;
        setObsolete(m_after == m_before);
        return true;
    }

private:
    PresetDocument &m_document;
    Preset m_before;
    Preset m_after;
    QString m_mergeKey;
};

PresetDocument::PresetDocument(Simulation &simulation, QObject *parent)
    : QObject(parent)
    , m_simulation(simulation)
    , m_original(simulation.preset())
{
}

void PresetDocument::open(const Preset &original, const std::optional<Preset> &edited)
{
    forgetEdits();
    m_original = original;
    m_simulation.setPreset(edited.value_or(original));
}

void PresetDocument::open(const Preset &original, const std::optional<Preset> &edited,
                          Program *program)
{
    forgetEdits();
    m_original = original;
    m_simulation.setRun(edited.value_or(original), program);
}

/// And a visit.
void PresetDocument::forgetEdits()
{
    m_undoStack.clear();
    if (std::exchange(m_own, std::nullopt))
        emit visitingChanged(false);
}

bool PresetDocument::edit(const QString &text, const Preset &changed, const QString &mergeKey)
{
    if (changed == preset())
        return true;
    if (const QString why = whyReadOnly(); !why.isEmpty()) {
        emit refused({.message = why});
        return false;
    }
    if (const std::optional<Error> fault = faultOf(changed)) {
        emit refused(*fault);
        return false;
    }
    m_undoStack.push(new PresetEdit(*this, text, changed, mergeKey));
    return true;
}

bool PresetDocument::startFromMoment()
{
    const auto circles = m_simulation.recording().circles(m_simulation.current());
    Preset changed = preset();
    for (std::size_t i = 0; i < changed.circles.size(); ++i)
        changed.circles[i].body = circles[i];
    changed.fill.reset(); // no longer the crowd that was drawn
    return edit(tr("Start from %1 s").arg(m_simulation.time(), 0, 'f', 3), changed);
}

void PresetDocument::setLocked(const QStringList &fields)
{
    if (fields == m_locked)
        return;
    m_locked = fields;
    emit lockedChanged();
}

void PresetDocument::setReadOnly(const QString &why)
{
    if (why == m_whyReadOnly)
        return;
    m_whyReadOnly = why;
    emit lockedChanged();
}

QString PresetDocument::whyReadOnly() const
{
    return isVisiting() ? tr("This is a scene of the check; go back to your own scene to change it")
                        : m_whyReadOnly;
}

QString PresetDocument::whyLocked(const QString &field) const
{
    if (const QString why = whyReadOnly(); !why.isEmpty())
        return why;
    return m_locked.contains(field) ? lockReason(field, m_original) : QString();
}

std::optional<Error> PresetDocument::faultOf(const Preset &changed) const
{
    for (const QString &field : m_locked) {
        if (firstChangedLock(preset(), changed, {field})
            && firstChangedLock(m_original, changed, {field}))
            return Error{.message = lockReason(field, m_original)};
    }
    return findFault(changed);
}

void PresetDocument::visit(const Preset &preset)
{
    if (!m_own)
        m_own = this->preset();
    m_simulation.setPreset(preset);
    emit visitingChanged(true);
}

void PresetDocument::leave()
{
    if (!m_own)
        return;
    const Preset own = *std::exchange(m_own, std::nullopt);
    emit visitingChanged(false);
    m_simulation.setPreset(own);
}

void PresetDocument::resetToOriginal()
{
    edit(tr("Reset to the step's own scene"), m_original);
}

void PresetDocument::apply(const Preset &preset)
{
    // Undo and redo speak of the student's own scene, so a visit ends here.
    if (std::exchange(m_own, std::nullopt))
        emit visitingChanged(false);
    m_simulation.setPreset(preset);
    emit edited();
}

} // namespace cradle
