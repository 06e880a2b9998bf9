// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/chart_svg.h"
#include "tasks/text/quantity_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cradle {

namespace {

const QString ink = QStringLiteral("#495057");
const QString gridColour = QStringLiteral("#dee2e6");
constexpr double fontSize = 10.0;       ///< px
constexpr double leftRoom = 52.0;       ///< px for numbers
constexpr double rightRoom = 64.0;      ///< px for names of curves
constexpr double topRoom = 20.0;        ///< px for the title
constexpr double bottomRoom = 18.0;     ///< px for numbers
constexpr std::size_t mostPoints = 400; ///< of a curve; more are not seen

/// What an axis shows.
struct Range {
    double first; ///< number, in steps from 0
    double last;
    double step; ///< between two numbers, 1, 2 or 5 times a power of ten

    [[nodiscard]] double part(double value) const
    {
        return (value / step - first) / (last - first);
    }
};

Range niceRange(double low, double high, int steps)
{
    const double least = 1e-9 * std::max({1.0, std::abs(low), std::abs(high)});
    if (!(high - low > least)) {
        const double room = std::max(std::abs(high) * 0.1, 1e-3);
        low -= room;
        high += room;
    }
    const double rough = (high - low) / steps;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double factor = rough / power;
    const double step = power
                        * (factor <= 1.0   ? 1.0
                           : factor <= 2.0 ? 2.0
                           : factor <= 5.0 ? 5.0
                                           : 10.0);
    return {std::floor(low / step), std::ceil(high / step), step};
}

QString numberText(double value, double step)
{
    const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    return std::abs(value) >= 1e5 || digits > 4 ? quantityText(value, 'g', 4)
                                                : quantityText(value, 'f', digits);
}

/// At most so many points, of which each group keeps its lowest and highest.
std::vector<Vec2> thinned(const std::vector<Vec2> &points)
{
    if (points.size() <= mostPoints)
        return points;
    std::vector<Vec2> result;
    const std::size_t groups = mostPoints / 2;
    for (std::size_t group = 0; group < groups; ++group) {
        const auto begin =
            points.begin() + static_cast<std::ptrdiff_t>(group * points.size() / groups);
        const auto end =
            points.begin() + static_cast<std::ptrdiff_t>((group + 1) * points.size() / groups);
        const auto [low, high] =
            std::minmax_element(begin, end, [](const Vec2 &a, const Vec2 &b) { return a.y < b.y; });
        result.push_back(*std::min(low, high));
        result.push_back(*std::max(low, high)); // the same twice is drawn once
    }
    return result;
}

class Chart
{
public:
    Chart(double width, double height, const QString &title, const std::vector<ChartLine> &lines)
        : m_picture(width, height, title)
        , m_size{width - leftRoom - rightRoom, height - topRoom - bottomRoom}
    {
        constexpr double far = std::numeric_limits<double>::infinity();
        Vec2 low{far, far};
        Vec2 high = -low;
        for (const ChartLine &line : lines) {
            for (const Vec2 &point : line.points) {
                low = {std::min(low.x, point.x), std::min(low.y, point.y)};
                high = {std::max(high.x, point.x), std::max(high.y, point.y)};
            }
        }
        if (low.x > high.x)
            low = high = {};
        m_x = niceRange(low.x, high.x, 6);
        m_y = niceRange(low.y, high.y, 4);
        m_picture.text({0.0, fontSize + 1.0}, title, fontSize + 1.0, ink);
        drawGrid();
        drawLines(lines);
    }

    [[nodiscard]] QByteArray toSvg() const { return m_picture.toSvg(); }

private:
    [[nodiscard]] Vec2 place(Vec2 point) const
    {
        return {leftRoom + m_x.part(point.x) * m_size.x,
                topRoom + (1.0 - m_y.part(point.y)) * m_size.y};
    }

    void drawGrid()
    {
        const Vec2 low{m_x.first * m_x.step, m_y.first * m_y.step};
        const Vec2 high{m_x.last * m_x.step, m_y.last * m_y.step};
        for (double i = m_y.first; i <= m_y.last; ++i) {
            const double y = i * m_y.step;
            const Vec2 left = place({low.x, y});
            m_picture.line(left, place({high.x, y}), {gridColour, 0.8});
            m_picture.text({left.x - 5.0, left.y + 3.5}, numberText(y, m_y.step), fontSize, ink,
                           SvgPicture::Anchor::End);
        }
        for (double i = m_x.first; i <= m_x.last; ++i) {
            const double x = i * m_x.step;
            const Vec2 bottom = place({x, low.y});
            m_picture.line(bottom, place({x, high.y}), {gridColour, 0.8});
            m_picture.text({bottom.x, bottom.y + fontSize + 4.0},
                           numberText(x, m_x.step)
                               + (i == m_x.last ? QStringLiteral(" s") : QString()),
                           fontSize, ink, SvgPicture::Anchor::Middle);
        }
    }

    void drawLines(const std::vector<ChartLine> &lines)
    {
        std::vector<std::pair<double, const ChartLine *>> names;
        for (const ChartLine &line : lines) {
            if (line.points.empty())
                continue;
            std::vector<Vec2> places;
            for (const Vec2 &point : thinned(line.points))
                places.push_back(place(point));
            m_picture.polyline(places, line.pen);
            names.emplace_back(places.back().y, &line);
        }
        drawNames(std::move(names));
    }

    /// Names stand at the ends of their curves, and never on each other: those that would are moved
    /// apart from the middle of where they belong.
    void drawNames(std::vector<std::pair<double, const ChartLine *>> names)
    {
        struct Cluster {
            double middle; ///< of the places that its names should have, px
            int count;
            [[nodiscard]] double first() const { return middle - 0.5 * (count - 1) * fontSize; }
            [[nodiscard]] double last() const { return middle + 0.5 * (count - 1) * fontSize; }
        };
        std::stable_sort(names.begin(), names.end(),
                         [](const auto &a, const auto &b) { return a.first < b.first; });
        std::vector<Cluster> clusters;
        for (const auto &[y, line] : names) {
            Cluster next{y + 3.5, 1};
            while (!clusters.empty() && clusters.back().last() + fontSize > next.first()) {
                const Cluster &before = clusters.back();
                const int count = before.count + next.count;
                next = {(before.middle * before.count + next.middle * next.count) / count, count};
                clusters.pop_back();
            }
            clusters.push_back(next);
        }
        const double most = topRoom + m_size.y + 4.0;
        double free = most - fontSize * static_cast<double>(names.size());
        double last = topRoom - fontSize;
        std::size_t at = 0;
        for (const Cluster &cluster : clusters) {
            for (int i = 0; i < cluster.count; ++i) {
                const double y = cluster.first() + i * fontSize;
                last = std::max(std::min(y, free + fontSize), last + fontSize);
                free += fontSize;
                const ChartLine &line = *names[at++].second;
                m_picture.text({leftRoom + m_size.x + 6.0, last}, line.name, fontSize,
                               line.pen.colour);
            }
        }
    }

    SvgPicture m_picture;
    Vec2 m_size; ///< of the field, px
    Range m_x{};
    Range m_y{};
};

} // namespace

QByteArray chartSvg(double width, double height, const QString &title,
                    const std::vector<ChartLine> &lines)
{
    return Chart(width, height, title, lines).toSvg();
}

} // namespace cradle
