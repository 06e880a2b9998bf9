// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QObject>
#include <QStringList>

QT_BEGIN_NAMESPACE
class QLineEdit;
QT_END_NAMESPACE

namespace cradle {

/// What was typed into the fields of a form and is no value. It stays there to be mended, with the
/// reason, whatever else is edited and wherever the author goes meanwhile.
class RefusedTexts final : public QObject
{
    Q_OBJECT
public:
    struct Text {
        QString typed;
        QString value;  ///< of the field when it was typed, as text
        QString reason; ///< empty: it waits for another field of the same value
    };

    /// What the fields belong to, as "STEP/CHECK"; every text is that of one subject.
    void setSubject(const QString &subject);
    /// The subject is called otherwise from now on.
    void rename(const QString &subject);
    /// What \p subject names is gone, and with it what was typed into its fields.
    void forget(const QString &subject);
    void keep(const QString &field, const Text &text);
    void drop(const QString &field);
    /// The text that \p field is to show in place of \p value; nullptr if there is none, or if the
    /// value was changed since, by an undo perhaps.
    [[nodiscard]] const Text *find(const QString &field, const QString &value);

    /// Shows \p value in a line, which is called by its object's name, or what find() says in its
    /// place; marks the line if that is no value.
    /// \param isNumber  the same number in other words stays: "2." while it becomes "2.5"
    void show(QLineEdit *line, const QString &value, bool isNumber = false);
    /// Keeps what is typed in a line in place of \p value, and marks the line; drops it if there is
    /// no \p reason why it is no value.
    void judge(QLineEdit *line, const QString &value, const QString &reason);

    /// Why the subject's first text is no value; empty if it has none.
    [[nodiscard]] QString reason() const;
    /// All subjects that have such texts.
    [[nodiscard]] QStringList subjects() const;

public slots:
    void clear();

signals:
    void changed(); ///< the texts, or the subject

private:
    QString m_subject{};
    QMap<QString, Text> m_texts{};
};

} // namespace cradle
