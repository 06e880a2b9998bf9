// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QString>
#include <QStringList>

namespace cradle {

/// What was typed into the fields of a form and is no value. It stays there to be mended, with the
/// reason, whatever else is edited and wherever the author goes meanwhile.
class RefusedTexts
{
public:
    struct Text {
        QString typed;
        QString value;  ///< of the field when it was typed, as text
        QString reason; ///< empty: it waits for another field of the same value
    };

    /// What the fields belong to, as "STEP/CHECK"; every text is that of one subject.
    void setSubject(const QString &subject) { m_subject = subject + QLatin1Char('\n'); }
    void keep(const QString &field, const Text &text) { m_texts.insert(m_subject + field, text); }
    void drop(const QString &field) { m_texts.remove(m_subject + field); }

    /// The text that \p field is to show in place of \p value; nullptr if there is none, or if the
    /// value was changed since, by an undo perhaps.
    [[nodiscard]] const Text *find(const QString &field, const QString &value)
    {
        const auto found = m_texts.find(m_subject + field);
        if (found == m_texts.end())
            return nullptr;
        if (found->value == value)
            return &*found;
        m_texts.erase(found);
        return nullptr;
    }

    /// Why the subject's first text is no value; empty if it has none.
    [[nodiscard]] QString reason() const
    {
        for (auto it = m_texts.lowerBound(m_subject);
             it != m_texts.end() && it.key().startsWith(m_subject); ++it) {
            if (!it->reason.isEmpty())
                return it->reason;
        }
        return {};
    }
    /// All subjects that have such texts.
    [[nodiscard]] QStringList subjects() const
    {
        QStringList subjects;
        for (auto it = m_texts.keyBegin(); it != m_texts.keyEnd(); ++it)
            subjects.append(it->section(QLatin1Char('\n'), 0, 0));
        subjects.removeDuplicates();
        return subjects;
    }
    /// The subject is called otherwise from now on.
    void rename(const QString &subject)
    {
        const QMap<QString, Text> texts = m_texts;
        for (auto it = texts.begin(); it != texts.end(); ++it) {
            if (!it.key().startsWith(m_subject))
                continue;
            m_texts.remove(it.key());
            m_texts.insert(subject + QLatin1Char('\n') + it.key().mid(m_subject.size()), *it);
        }
        setSubject(subject);
    }
    void clear() { m_texts.clear(); }

private:
    QString m_subject{};
    QMap<QString, Text> m_texts{};
};

} // namespace cradle
