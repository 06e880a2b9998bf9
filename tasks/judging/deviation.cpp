// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/deviation.h"

#include "tasks/judging/likeness.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct SayText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

constexpr double patternBlur = 1e-4; ///< relative

} // namespace

QString brief(double value)
{
    // Six places behind the point are written at most.
    if (std::abs(value) < 5e-7)
        return QStringLiteral("0");
    // What lies between two figures, as 9.81/60, is rounded up whatever noise it carries.
    value *= 1.0 + 1e-9;
    const double size = std::abs(value);
    // Whole numbers that are not long stay whole, and none is written with an exponent.
    if (size >= 999.5 && size < 1e6)
        return QString::number(std::round(value), 'f', 0);
    const QString text = QString::number(value, 'g', 3);
    const bool isSmall = size < 1.0 && text.contains(QLatin1Char('e'));
    return isSmall ? QString::number(value, 'f', 6) : text;
}

QString brief(Vec2 value)
{
    return QStringLiteral("(%1, %2)").arg(brief(value.x), brief(value.y));
}

QString briefTimestep(double seconds)
{
    const double parts = 1.0 / seconds;
    return std::abs(parts - std::round(parts)) < 1e-6 ? QStringLiteral("1/%1").arg(qRound(parts))
                                                      : brief(seconds);
}

QString circleNames(const std::vector<int> &circles, std::size_t all)
{
    if (circles.size() == 1)
        return SayText::tr("circle %1").arg(circles.front() + 1);
    if (circles.size() == all)
        return all == 2 ? SayText::tr("both circles") : SayText::tr("all circles");
    QStringList numbers;
    for (const int circle : circles)
        numbers.append(QString::number(circle + 1));
    return SayText::tr("the circles %1").arg(spokenList(numbers));
}

TimestepPattern patternOf(const std::vector<std::pair<double, double>> &factors)
{
    using Pattern = TimestepPattern::Kind;
    const auto all = [&](auto &&value, double wanted) {
        for (const auto &[h, factor] : factors) {
            if (!isAlike(value(h, factor) / wanted, 1.0, patternBlur))
                return false;
        }
        return true;
    };
    if (factors.empty())
        return {};
    const auto [h0, f0] = factors.front();
    if (all([](double h, double f) { return f * h; }, 1.0))
        return {Pattern::Forgotten, 1.0};
    if (all([](double h, double f) { return f / h; }, 1.0))
        return {Pattern::Squared, 1.0};
    if (all([](double h, double f) { return f * h * h; }, 1.0))
        return {Pattern::Divided, 1.0};
    const bool constant = std::all_of(factors.begin(), factors.end(), [f = f0](const auto &each) {
        return isAlike(each.second, f, patternBlur);
    });
    if (constant)
        return {Pattern::Constant, f0};
    if (f0 > 0.0 && all([](double h, double f) { return f * h; }, f0 * h0))
        return {Pattern::Fixed, f0 * h0};
    return {Pattern::Other, f0};
}

} // namespace cradle
