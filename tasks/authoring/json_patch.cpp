// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/json_patch.h"

#include "tasks/authoring/json_text.h"

#include <QJsonArray>

#include <algorithm>

namespace cradle {

namespace {

/// Of an object on lines of their own, "checks" and the like take lines as well.
constexpr int levelsOfAFile = 2;

QByteArray patched(const QByteArray &text, const QJsonValue &before, const QJsonValue &after,
                   int levels, const QByteArray &indent);

/// The spaces that the lines inside begin with; \p fallback if all is on one line.
QByteArray indentOf(const JsonPieces &pieces, const QByteArray &fallback)
{
    const qsizetype line = pieces.open.lastIndexOf('\n');
    return line < 0 ? fallback : pieces.open.mid(line + 1);
}

/// Gives a container that was empty the layout of a printed one.
void layOut(JsonPieces &pieces, bool lines, const QByteArray &indent)
{
    if (!pieces.pieces.empty() || !lines)
        return;
    pieces.open = pieces.open.left(1) + '\n' + indent + "  ";
    pieces.separator = ",\n" + indent + "  ";
    pieces.close = '\n' + indent + pieces.close.right(1);
}

void insertMember(JsonPieces &pieces, const QString &key, const QByteArray &value)
{
    const auto after = std::find_if(
        pieces.pieces.begin(), pieces.pieces.end(),
        [&](const JsonPieces::Piece &piece) { return rankOf(piece.key) > rankOf(key); });
    const QByteArray lead = printJson(key, 0, {}) + ": ";
    pieces.pieces.insert(after, {.key = key, .lead = lead, .value = value, .gap = {}});
}

/// Of an object that is not written yet, the members that an edit changed; else \p after.
QJsonValue differenceOf(const QJsonValue &before, const QJsonValue &after)
{
    if (!before.isObject() || !after.isObject())
        return after;
    QJsonObject changed;
    const QJsonObject old = before.toObject();
    const QJsonObject wanted = after.toObject();
    for (const QString &key : wanted.keys()) {
        if (old.value(key) != wanted.value(key))
            changed.insert(key, wanted.value(key));
    }
    return changed;
}

QByteArray patchedObject(const QByteArray &text, const QJsonObject &before,
                         const QJsonObject &after, int levels, const QByteArray &indent)
{
    JsonPieces pieces = takeApart(text);
    layOut(pieces, levels > 0, indent);
    const QByteArray inner = indentOf(pieces, indent + "  ");
    for (const QString &key : before.keys()) {
        const int at = pieces.indexOf(key);
        if (!after.contains(key) && at >= 0)
            pieces.pieces.erase(pieces.pieces.begin() + at);
    }
    for (const QString &key : after.keys()) {
        const QJsonValue value = after.value(key);
        if (value == before.value(key) && before.contains(key))
            continue;
        const int at = pieces.indexOf(key);
        if (at < 0) {
            insertMember(pieces, key,
                         printJson(differenceOf(before.value(key), value), levels - 1, inner));
            continue;
        }
        QByteArray &old = pieces.pieces[static_cast<std::size_t>(at)].value;
        old = patched(old, before.value(key), value, levels - 1, inner);
    }
    return pieces.toText();
}

/// The element of \p before that \p element is, or that it was before an edit; −1 if it is new.
qsizetype originOf(const QJsonValue &element, qsizetype index, const QJsonArray &before,
                   qsizetype countAfter)
{
    for (qsizetype i = 0; i < before.size(); ++i) {
        if (before.at(i) == element)
            return i;
    }
    const QString id = element.toObject().value(QStringLiteral("id")).toString();
    for (qsizetype i = 0; i < before.size() && !id.isEmpty(); ++i) {
        if (before.at(i).toObject().value(QStringLiteral("id")).toString() == id)
            return i;
    }
    return before.size() == countAfter ? index : -1;
}

QByteArray patchedList(const QByteArray &text, const QJsonArray &before, const QJsonArray &after,
                       int levels, const QByteArray &indent)
{
    JsonPieces pieces = takeApart(text);
    const bool lines = levels > 0 && !after.isEmpty() && !after.first().isDouble();
    layOut(pieces, lines, indent);
    const QByteArray inner = indentOf(pieces, indent + "  ");
    std::vector<JsonPieces::Piece> wanted;
    for (qsizetype i = 0; i < after.size(); ++i) {
        const QJsonValue element = after.at(i);
        const qsizetype origin = originOf(element, i, before, after.size());
        const bool isWritten = origin >= 0 && origin < qsizetype(pieces.pieces.size());
        JsonPieces::Piece piece;
        if (isWritten) {
            const JsonPieces::Piece &old = pieces.pieces[static_cast<std::size_t>(origin)];
            piece.value = patched(old.value, before.at(origin), element, levels - 2, inner);
            if (origin == i)
                piece.gap = old.gap;
        } else {
            piece.value = printJson(element, levels - 2, inner);
        }
        wanted.push_back(piece);
    }
    pieces.pieces = wanted;
    return pieces.toText();
}

/// \p text stands for \p before and becomes that for \p after.
QByteArray patched(const QByteArray &text, const QJsonValue &before, const QJsonValue &after,
                   int levels, const QByteArray &indent)
{
    if (before == after)
        return text;
    if (before.isObject() && after.isObject() && text.startsWith('{'))
        return patchedObject(text, before.toObject(), after.toObject(), levels, indent);
    if (before.isArray() && after.isArray() && text.startsWith('['))
        return patchedList(text, before.toArray(), after.toArray(), levels, indent);
    return printJson(after, levels, indent);
}

} // namespace

QByteArray patchJson(const QByteArray &text, const QJsonObject &before, const QJsonObject &after)
{
    if (before == after)
        return text;
    // What stands before and after the object stays, too.
    const qsizetype from = text.indexOf('{');
    const qsizetype to = text.lastIndexOf('}') + 1;
    return text.left(from)
           + patchedObject(text.mid(from, to - from), before, after, levelsOfAFile, {})
           + text.mid(to);
}

} // namespace cradle
