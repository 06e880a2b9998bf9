// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/told_step_bytes.h"

#include <QDataStream>
#include <QXmlStreamReader>

#include <cmath>

namespace cradle {

namespace {

constexpr quint32 mostItems = 1'000'000; ///< of any list

QDataStream &operator<<(QDataStream &out, const DiffLine &line)
{
    return out << static_cast<qint32>(line.kind) << line.text << qint32(line.before)
               << qint32(line.after);
}
QDataStream &operator>>(QDataStream &in, DiffLine &line)
{
    qint32 kind = 0;
    qint32 before = 0;
    qint32 after = 0;
    in >> kind >> line.text >> before >> after;
    if (kind < 0 || kind > static_cast<qint32>(DiffLine::Kind::Added))
        in.setStatus(QDataStream::ReadCorruptData);
    line.kind = static_cast<DiffLine::Kind>(kind);
    line.before = before;
    line.after = after;
    return in;
}

QDataStream &operator<<(QDataStream &out, const StepReport::Met &met)
{
    return out << met.headline << qint32(met.times);
}
QDataStream &operator>>(QDataStream &in, StepReport::Met &met)
{
    qint32 times = 0;
    in >> met.headline >> times;
    met.times = times;
    return in;
}

QDataStream &operator<<(QDataStream &out, const Vec2 &point)
{
    return out << point.x << point.y;
}
QDataStream &operator>>(QDataStream &in, Vec2 &point)
{
    in >> point.x >> point.y;
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
        in.setStatus(QDataStream::ReadCorruptData);
    return in;
}

QDataStream &operator<<(QDataStream &out, const DiffHunk &hunk);
QDataStream &operator>>(QDataStream &in, DiffHunk &hunk);

template <typename Item>
void writeList(QDataStream &out, const std::vector<Item> &list)
{
    out << static_cast<quint32>(list.size());
    for (const Item &item : list)
        out << item;
}

template <typename Item>
void readList(QDataStream &in, std::vector<Item> &list)
{
    quint32 size = 0;
    in >> size;
    if (size > mostItems)
        in.setStatus(QDataStream::ReadCorruptData);
    for (quint32 i = 0; i < size && in.status() == QDataStream::Ok; ++i) {
        list.emplace_back();
        in >> list.back();
    }
}

QDataStream &operator<<(QDataStream &out, const DiffHunk &hunk)
{
    writeList(out, hunk.lines);
    return out;
}
QDataStream &operator>>(QDataStream &in, DiffHunk &hunk)
{
    readList(in, hunk.lines);
    return in;
}

} // namespace

QByteArray bytesOf(const ToldStep &told)
{
    const StepReport &step = told.report;
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setVersion(QDataStream::Qt_6_4);
    out << step.id << step.title << step.asked << static_cast<qint32>(step.verdict)
        << step.explanation << step.byProgram << step.moment << step.scene << step.momentum
        << step.energy << step.question << step.expected << step.right << step.wasRight
        << qint32(step.attempts) << step.note << told.curve.name;
    writeList(out, step.change);
    writeList(out, step.met);
    writeList(out, told.curve.points);
    return bytes;
}

std::optional<ToldStep> toldStepFrom(const QByteArray &bytes)
{
    ToldStep told;
    StepReport &step = told.report;
    qint32 verdict = 0;
    qint32 attempts = 0;
    QDataStream in(bytes);
    in.setVersion(QDataStream::Qt_6_4);
    in >> step.id >> step.title >> step.asked >> verdict >> step.explanation >> step.byProgram
        >> step.moment >> step.scene >> step.momentum >> step.energy >> step.question
        >> step.expected >> step.right >> step.wasRight >> attempts >> step.note >> told.curve.name;
    readList(in, step.change);
    readList(in, step.met);
    readList(in, told.curve.points);
    step.verdict = static_cast<StepVerdict>(verdict);
    step.attempts = attempts;
    const bool isRight = in.status() == QDataStream::Ok && in.atEnd() && verdict >= 0
                         && verdict <= static_cast<qint32>(StepVerdict::Stopped)
                         && isPlainDrawing(step.scene) && isPlainDrawing(step.momentum)
                         && isPlainDrawing(step.energy);
    return isRight ? std::optional(std::move(told)) : std::nullopt;
}

bool isPlainDrawing(const QByteArray &svg)
{
    static const QStringList elements{QStringLiteral("svg"),      QStringLiteral("title"),
                                      QStringLiteral("rect"),     QStringLiteral("circle"),
                                      QStringLiteral("polyline"), QStringLiteral("polygon"),
                                      QStringLiteral("text")};
    static const QStringList refused{QStringLiteral("style"), QStringLiteral("href"),
                                     QStringLiteral("class"), QStringLiteral("id")};
    if (svg.isEmpty())
        return true;
    QXmlStreamReader reader(svg);
    while (!reader.atEnd()) {
        switch (reader.readNext()) {
        case QXmlStreamReader::StartElement:
            if (!elements.contains(reader.name()))
                return false;
            for (const QXmlStreamAttribute &each : reader.attributes()) {
                if (refused.contains(each.name()) || each.name().startsWith(u"on")
                    || each.value().contains(u"url(") || !each.prefix().isEmpty())
                    return false;
            }
            break;
        case QXmlStreamReader::DTD:
        case QXmlStreamReader::EntityReference:
        case QXmlStreamReader::ProcessingInstruction:
        case QXmlStreamReader::Comment:
            return false;
        default:
            break;
        }
    }
    return !reader.hasError();
}

} // namespace cradle
