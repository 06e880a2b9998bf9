// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_tests.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// How much shorter a length along \p n is than the sum of its parts x and y.
double partsOf(Vec2 n)
{
    return std::abs(n.x) + std::abs(n.y);
}

double largerPartOf(Vec2 n)
{
    return std::max(std::abs(n.x), std::abs(n.y));
}

/// Of the lengths before and after the step in which they are answered.
template <class Part>
double least(const PairHit &h, Part part)
{
    return std::min(std::abs(part(h.normal)), std::abs(part(h.nextNormal)));
}

} // namespace

std::vector<ContactTest> contactTests()
{
    const QString one =
        ContactText::tr("Rims touch where the centres are r₁ + r₂ apart, here %1 m.");
    const QString alone =
        ContactText::tr("A distance is the root of the sum of the squares of both differences.");
    std::vector<ContactTest> all{
        {[](const PairHit &) { return 0.0; },
         ContactText::tr("The circles answer only when their centres have met"), one},
        {[](const PairHit &h) {
             return h.meeting.sum() / std::min(largerPartOf(h.normal), largerPartOf(h.nextNormal));
         },
         ContactText::tr("Boxes are compared, not circles"),
         ContactText::tr("Side by side they answer in time, but on a diagonal when their centres "
                         "are still %2 m apart: x and y each on its own ask for squares. Make one "
                         "distance out of the two differences.")},
        {[](const PairHit &h) {
             return h.meeting.sum() / std::min(partsOf(h.normal), partsOf(h.nextNormal));
         },
         ContactText::tr("|Δx| + |Δy| is not the distance"),
         ContactText::tr("Side by side they answer in time, but on a diagonal only when their "
                         "centres are %2 m apart. A distance is the root of the sum of the "
                         "squares.")},
        {[](const PairHit &h) { return h.meeting.sum() / least(h, [](Vec2 n) { return n.x; }); },
         ContactText::tr("The circles are compared in x alone"), alone, true},
        {[](const PairHit &h) { return h.meeting.sum() / least(h, [](Vec2 n) { return n.y; }); },
         ContactText::tr("The circles are compared in y alone"), alone, true},
        {[](const PairHit &h) {
             return h.meeting.sum() / least(h, [](Vec2 n) { return n.x + n.y; });
         },
         ContactText::tr("|Δx + Δy| is not the distance"), alone, true},
        {[](const PairHit &h) { return std::sqrt(h.meeting.sum()); },
         ContactText::tr("A squared distance is compared with a length"),
         ContactText::tr(
             "They answer %2 m apart: that squared is about r₁ + r₂. A square is in m², a "
             "length in m.")},
        {[](const PairHit &h) { return 0.5 * h.meeting.sum(); },
         ContactText::tr("Only half of r₁ + r₂ counts in the test of contact"), one}};
    const auto add = [&](double (*distance)(double, double), const QString &what) {
        all.push_back({[distance](const PairHit &h) {
                           return distance(h.meeting.radius1, h.meeting.radius2);
                       },
                       ContactText::tr("Contact is tested at %1, not at r₁ + r₂").arg(what), one});
    };
    add([](double a, double) { return 2.0 * a; }, QStringLiteral("2 r₁"));
    add([](double, double b) { return 2.0 * b; }, QStringLiteral("2 r₂"));
    add([](double a, double) { return a; }, QStringLiteral("r₁"));
    add([](double, double b) { return b; }, QStringLiteral("r₂"));
    add([](double a, double b) { return std::max(a, b); }, ContactText::tr("the larger radius"));
    add([](double a, double b) { return std::min(a, b); }, ContactText::tr("the smaller radius"));
    add([](double a, double b) { return 2.0 * std::min(a, b); },
        ContactText::tr("twice the smaller radius"));
    add([](double a, double b) { return b - a; }, QStringLiteral("r₂ − r₁"));
    add([](double a, double b) { return a - b; }, QStringLiteral("r₁ − r₂"));
    add([](double a, double b) { return std::abs(a - b); },
        ContactText::tr("the difference of the radii"));
    add([](double a, double b) { return 2.0 * std::max(a, b); },
        ContactText::tr("twice the larger radius"));
    add([](double a, double b) { return std::sqrt(a * a + b * b); },
        QStringLiteral("√(r₁² + r₂²)"));
    add([](double a, double b) { return 2.0 * std::sqrt(a * b); }, QStringLiteral("2 √(r₁ r₂)"));
    add([](double a, double b) { return 2.0 * (a + b); },
        ContactText::tr("the sum of the diameters"));
    return all;
}

} // namespace cradle
