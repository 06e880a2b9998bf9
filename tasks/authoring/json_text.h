// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonValue>
#include <QString>

#include <vector>

namespace cradle {

/// A list or an object of JSON as it is written: the text of each element or member, and what
/// stands around them.
struct JsonPieces {
    struct Piece {
        QString key{};     ///< of a member; empty for an element
        QByteArray lead{}; ///< "key": with its spaces; empty for an element
        QByteArray value{};
        QByteArray gap{}; ///< between the piece before and this one; empty: the separator
    };

    QByteArray open;             ///< the bracket and the space after it
    QByteArray separator = ", "; ///< between a new piece and the one before
    QByteArray close;            ///< the space before the bracket and the bracket
    std::vector<Piece> pieces{};

    [[nodiscard]] QByteArray toText() const;
    /// The index of the member; −1 if there is none.
    [[nodiscard]] int indexOf(const QString &key) const;
};

/// Takes a list or an object apart. Among members of one name the last counts, as in QJson; the
/// others are dropped.
/// \pre text is valid JSON, and begins with a bracket (after spaces, which are dropped)
[[nodiscard]] JsonPieces takeApart(const QByteArray &text);

/// A value as text. Containers that stand fewer than \p levels deep take a line for each of their
/// members (and of their elements, unless these are numbers); all others stand on one line.
/// \param indent  of the line that the value begins on
[[nodiscard]] QByteArray printJson(const QJsonValue &value, int levels, const QByteArray &indent);

/// Where a key belongs among others: the order of the formats, then all that they do not know.
[[nodiscard]] int rankOf(const QString &key);

} // namespace cradle
