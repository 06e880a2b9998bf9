// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/json_text.h"

#include "model/world/shortest_number.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>

namespace cradle {

namespace {

bool isSpace(char c)
{
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

qsizetype skipSpace(const QByteArray &text, qsizetype at)
{
    while (at < text.size() && isSpace(text[at]))
        ++at;
    return at;
}

/// The place after the string that begins at \p at.
qsizetype skipString(const QByteArray &text, qsizetype at)
{
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\')
            ++at;
    }
    return std::min(at + 1, text.size());
}

/// The place after the value that begins at \p at.
qsizetype skipValue(const QByteArray &text, qsizetype at)
{
    int depth = 0;
    while (at < text.size()) {
        const char c = text[at];
        if (c == '"') {
            at = skipString(text, at);
            continue;
        }
        if (c == '{' || c == '[')
            ++depth;
        if (c == '}' || c == ']') {
            if (depth == 0)
                return at; // a number or a word ended before it
            --depth;
        }
        if (depth == 0 && (c == ',' || isSpace(c)))
            return at;
        ++at;
    }
    return at;
}

QString unquoted(const QByteArray &text)
{
    return QJsonDocument::fromJson('[' + text + ']').array().at(0).toString();
}

QByteArray quoted(const QString &text)
{
    // QJsonDocument knows how to escape; a list of one is the smallest document that it writes.
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return list.mid(1, list.size() - 2);
}

QByteArray scalar(const QJsonValue &value)
{
    if (value.isString())
        return quoted(value.toString());
    if (value.isDouble())
        return shortestNumber(value.toDouble()).toLatin1();
    if (value.isBool())
        return value.toBool() ? "true" : "false";
    return "null";
}

QByteArray joined(const std::vector<QByteArray> &parts, const char *brackets, bool lines,
                  const QByteArray &indent)
{
    if (parts.empty())
        return QByteArray(brackets, 2);
    const QByteArray inner = lines ? '\n' + indent + "  " : QByteArray();
    QByteArray text(brackets, 1);
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0 ? inner : (lines ? ',' + inner : QByteArray(", "))) + parts[i];
    return text + (lines ? '\n' + indent : QByteArray()) + brackets[1];
}

/// The keys of all formats, in the order that people read them in.
constexpr std::array keyOrder{
    "format",    "id",       "name",     "kind",       "title",      "version",      "language",
    "commit",    "question", "preset",   "square",     "half_width", "gravity",      "restitution",
    "timestep",  "laws",     "walls",    "fill",       "count",      "compare",      "duration",
    "timesteps", "speeds",   "offset",   "both_move",  "again",      "restitutions", "radii",
    "densities", "position", "velocity", "radius",     "density",    "colour",       "integrator",
    "rms_speed", "seed",     "hints",    "code_hints", "circles",    "points",       "parameters",
    "scene",     "checks",   "mistakes", "remarks",    "from",       "to",           "step",
    "values",    "draw",     "edition",  "steps",      "moves",      "extra",        "locked"};

} // namespace

QByteArray JsonPieces::toText() const
{
    if (pieces.empty())
        return open.left(1) + close.right(1);
    QByteArray text = open;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (i > 0)
            text += pieces[i].gap.isEmpty() ? separator : pieces[i].gap;
        text += pieces[i].lead + pieces[i].value;
    }
    return text + close;
}

int JsonPieces::indexOf(const QString &key) const
{
    const auto found = std::find_if(pieces.begin(), pieces.end(),
                                    [&](const Piece &piece) { return piece.key == key; });
    return found == pieces.end() ? -1 : static_cast<int>(found - pieces.begin());
}

JsonPieces takeApart(const QByteArray &text)
{
    JsonPieces result;
    qsizetype at = skipSpace(text, 0);
    const bool isObject = text[at] == '{';
    const qsizetype first = skipSpace(text, at + 1);
    result.open = text.mid(at, first - at);
    at = first;
    QByteArray gap;
    while (at < text.size() && text[at] != '}' && text[at] != ']') {
        JsonPieces::Piece piece;
        qsizetype value = at;
        if (isObject) {
            const qsizetype afterKey = skipString(text, at);
            piece.key = unquoted(text.mid(at, afterKey - at));
            value = skipSpace(text, skipSpace(text, afterKey) + 1); // over the colon
            piece.lead = text.mid(at, value - at);
        }
        const qsizetype end = skipValue(text, value);
        piece.value = text.mid(value, end - value);
        piece.gap = gap;
        if (isObject)
            std::erase_if(result.pieces, [&](const auto &twin) { return twin.key == piece.key; });
        const qsizetype comma = skipSpace(text, end);
        if (comma < text.size() && text[comma] == ',') {
            at = skipSpace(text, comma + 1);
            gap = text.mid(end, at - end);
            if (result.pieces.empty())
                result.separator = gap;
        } else {
            result.close = text.mid(end, comma - end);
            at = comma;
        }
        result.pieces.push_back(piece);
    }
    result.close += isObject ? '}' : ']';
    if (result.pieces.size() == 1 && result.open.contains('\n'))
        result.separator = ',' + result.open.mid(1);
    return result;
}

QByteArray printJson(const QJsonValue &value, int levels, const QByteArray &indent)
{
    std::vector<QByteArray> parts;
    if (value.isArray()) {
        const QJsonArray list = value.toArray();
        const bool lines = levels > 0 && !list.isEmpty() && !list.first().isDouble();
        for (const QJsonValue &element : list)
            parts.push_back(printJson(element, lines ? levels - 2 : 0, indent + "  "));
        return joined(parts, "[]", lines, indent);
    }
    if (!value.isObject())
        return scalar(value);
    const QJsonObject object = value.toObject();
    QStringList keys = object.keys();
    std::stable_sort(keys.begin(), keys.end(),
                     [](const QString &a, const QString &b) { return rankOf(a) < rankOf(b); });
    for (const QString &key : std::as_const(keys))
        parts.push_back(quoted(key) + ": "
                        + printJson(object.value(key), levels - 1, indent + "  "));
    return joined(parts, "{}", levels > 0, indent);
}

int rankOf(const QString &key)
{
    const auto found = std::find_if(keyOrder.begin(), keyOrder.end(),
                                    [&](const char *name) { return key == QLatin1String(name); });
    return static_cast<int>(found - keyOrder.begin());
}

} // namespace cradle
