// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <vector>

namespace cradle {

struct Label {
    QString text;
    Vec2 place;
    QString anchor;
};

/// What an SVG draws.
struct Drawn {
    explicit Drawn(const QByteArray &svg)
    {
        QXmlStreamReader xml(svg);
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement)
                continue;
            const auto attribute = [&](const char *name) {
                return xml.attributes().value(QLatin1String(name)).toString();
            };
            if (xml.name() == QLatin1String("polyline")) {
                lines.emplace_back(attribute("stroke"), pointsOf(attribute("points")));
            } else if (xml.name() == QLatin1String("polygon")) {
                heads.push_back(pointsOf(attribute("points")));
            } else if (xml.name() == QLatin1String("text")) {
                const Vec2 place{attribute("x").toDouble(), attribute("y").toDouble()};
                const QString anchor = attribute("text-anchor");
                labels.push_back({xml.readElementText(), place, anchor});
            }
        }
        isSound = !xml.hasError();
    }

    static std::vector<Vec2> pointsOf(const QString &text)
    {
        std::vector<Vec2> points;
        for (const QString &each : text.split(QLatin1Char(' ')))
            points.push_back({each.section(QLatin1Char(','), 0, 0).toDouble(),
                              each.section(QLatin1Char(','), 1).toDouble()});
        return points;
    }
    /// Those beside the left end of the field, or under it.
    [[nodiscard]] std::vector<Label> numbers(bool ofY) const
    {
        std::vector<Label> found;
        std::copy_if(
            labels.begin(), labels.end(), std::back_inserter(found), [&](const Label &label) {
                return label.anchor == (ofY ? QLatin1String("end") : QLatin1String("middle"));
            });
        return found;
    }
    [[nodiscard]] QStringList texts(bool ofY) const
    {
        QStringList all;
        for (const Label &label : numbers(ofY))
            all.append(label.text);
        return all;
    }
    [[nodiscard]] std::vector<Vec2> curve(const QString &colour) const
    {
        const auto found = std::find_if(lines.begin(), lines.end(),
                                        [&](const auto &line) { return line.first == colour; });
        return found == lines.end() ? std::vector<Vec2>{} : found->second;
    }

    std::vector<std::pair<QString, std::vector<Vec2>>> lines;
    std::vector<std::vector<Vec2>> heads;
    std::vector<Label> labels;
    bool isSound = false;
};

} // namespace cradle
