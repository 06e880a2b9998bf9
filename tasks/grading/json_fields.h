// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QJsonArray>
#include <QJsonObject>

#include <optional>

namespace cradle {

/// Reads the values of a JSON object one by one, each of a type and within bounds; a schema would
/// take many times as long for lists of numbers. What is not as it should be reads as nothing, and
/// the first such place is kept as the fault.
class JsonFields
{
public:
    /// The reader of a whole file. \param source  its name, for messages
    JsonFields(const QJsonObject &object, const QString &source);
    /// The reader of a part: its faults are those of \p parent, which must outlive this.
    JsonFields(JsonFields &parent, const QString &key);
    JsonFields(JsonFields &parent, const QString &key, const QJsonValue &element, qsizetype index);

    [[nodiscard]] bool has(const char *key) const; ///< neither left out nor null

    [[nodiscard]] QString text(const char *key, qsizetype mostLetters);
    [[nodiscard]] double number(const char *key, double low, double high);
    [[nodiscard]] qint64 integer(const char *key, qint64 low, qint64 high);
    [[nodiscard]] bool flag(const char *key);
    [[nodiscard]] QJsonArray list(const char *key, qsizetype most);
    [[nodiscard]] QJsonObject object(const char *key);

    /// Keeps a fault at that place, unless there is one already.
    void refuse(const QString &key, const QString &message);
    [[nodiscard]] const std::optional<Error> &fault() const { return m_root->m_fault; }

private:
    [[nodiscard]] QJsonValue at(const char *key) const;
    void refuse(const char *key, const QString &right);

    QJsonObject m_object;
    QString m_pointer{};
    QString m_source{};             ///< of the root
    std::optional<Error> m_fault{}; ///< of the root
    JsonFields *m_root = this;
};

} // namespace cradle
