// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/refused_texts.h"

#include "model/files/expression.h"
#include "views/author/form_rows.h"

#include <QLineEdit>

namespace cradle {

namespace {

/// Between a subject and a field.
constexpr QLatin1Char between('\n');

bool areSameNumber(const QString &typed, const QString &text)
{
    const Result<double> a = evaluated(typed);
    const Result<double> b = evaluated(text);
    return a && b && *a == *b;
}

} // namespace

void RefusedTexts::setSubject(const QString &subject)
{
    m_subject = subject + between;
    emit changed();
}

void RefusedTexts::rename(const QString &subject)
{
    const QMap<QString, Text> texts = m_texts;
    for (auto it = texts.begin(); it != texts.end(); ++it) {
        if (!it.key().startsWith(m_subject))
            continue;
        m_texts.remove(it.key());
        m_texts.insert(subject + between + it.key().mid(m_subject.size()), *it);
    }
    setSubject(subject);
}

void RefusedTexts::forget(const QString &subject)
{
    const auto isOfIt = [start = subject + between](const auto &text) {
        return text.key().startsWith(start);
    };
    if (m_texts.removeIf(isOfIt) > 0)
        emit changed();
}

void RefusedTexts::keep(const QString &field, const Text &text)
{
    m_texts.insert(m_subject + field, text);
    emit changed();
}

void RefusedTexts::drop(const QString &field)
{
    if (m_texts.remove(m_subject + field) > 0)
        emit changed();
}

const RefusedTexts::Text *RefusedTexts::find(const QString &field, const QString &value)
{
    const auto found = m_texts.constFind(m_subject + field);
    if (found == m_texts.cend())
        return nullptr;
    if (found->value == value)
        return &*found;
    drop(field);
    return nullptr;
}

void RefusedTexts::show(QLineEdit *line, const QString &value, bool isNumber)
{
    const Text *refused = find(line->objectName(), value);
    const QString text = refused ? refused->typed : value;
    const QString shown = line->text();
    if (shown.trimmed() != text.trimmed() && !(isNumber && areSameNumber(shown, text)))
        line->setText(text);
    markRefused(line, refused && !refused->reason.isEmpty());
}

void RefusedTexts::judge(QLineEdit *line, const QString &value, const QString &reason)
{
    if (reason.isEmpty())
        drop(line->objectName());
    else
        keep(line->objectName(), {line->text(), value, reason});
    markRefused(line, !reason.isEmpty());
}

QString RefusedTexts::reason() const
{
    for (auto it = m_texts.lowerBound(m_subject);
         it != m_texts.end() && it.key().startsWith(m_subject); ++it) {
        if (!it->reason.isEmpty())
            return it->reason;
    }
    return {};
}

QStringList RefusedTexts::subjects() const
{
    QStringList subjects;
    for (auto it = m_texts.keyBegin(); it != m_texts.keyEnd(); ++it)
        subjects.append(it->section(between, 0, 0));
    subjects.removeDuplicates();
    return subjects;
}

void RefusedTexts::clear()
{
    m_texts.clear();
    emit changed();
}

} // namespace cradle
