// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/chart_svg.h"
#include "tasks/text/quantity_text.h"

#include <algorithm>
#include <cmath>

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
    double low = 0.0;
    double high = 1.0;
    double step = 1.0; ///< between two numbers, 1, 2 or 5 times a power of ten

    [[nodiscard]] double part(double value) const { return (value - low) / (high - low); }
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
    return {std::floor(low / step) * step, std::ceil(high / step) * step, step};
}

QString numberText(double value, double step)
{
    if (std::abs(value) < 1e-6 * step)
        value = 0.0;
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
        auto [low, high] =
            std::minmax_element(begin, end, [](const Vec2 &a, const Vec2 &b) { return a.y < b.y; });
        if (high < low)
            std::swap(low, high);
        result.push_back(*low);
        if (low != high)
            result.push_back(*high);
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
        Vec2 low{1e300, 1e300};
        Vec2 high{-1e300, -1e300};
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
        for (double y = m_y.low; y <= m_y.high + 0.5 * m_y.step; y += m_y.step) {
            const Vec2 left = place({m_x.low, y});
            m_picture.line(left, place({m_x.high, y}), {gridColour, 0.8});
            m_picture.text({left.x - 5.0, left.y + 3.5}, numberText(y, m_y.step), fontSize, ink,
                           SvgPicture::Anchor::End);
        }
        for (double x = m_x.low; x <= m_x.high + 0.5 * m_x.step; x += m_x.step) {
            const Vec2 bottom = place({x, m_y.low});
            m_picture.line(bottom, place({x, m_y.high}), {gridColour, 0.8});
            const bool isLast = x + m_x.step > m_x.high + 0.5 * m_x.step;
            m_picture.text({bottom.x, bottom.y + fontSize + 4.0},
                           numberText(x, m_x.step) + (isLast ? QStringLiteral(" s") : QString()),
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
            double count;
            [[nodiscard]] double first() const { return middle - 0.5 * (count - 1.0) * fontSize; }
            [[nodiscard]] double last() const { return middle + 0.5 * (count - 1.0) * fontSize; }
        };
        std::stable_sort(names.begin(), names.end(),
                         [](const auto &a, const auto &b) { return a.first < b.first; });
        std::vector<Cluster> clusters;
        for (const auto &[y, line] : names) {
            Cluster next{y + 3.5, 1.0};
            while (!clusters.empty() && clusters.back().last() + fontSize > next.first()) {
                const Cluster &before = clusters.back();
                const double count = before.count + next.count;
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
            for (double y = cluster.first(); y < cluster.last() + 0.5 * fontSize; y += fontSize) {
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
