// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/examples.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct ExampleText {
    Q_DECLARE_TR_FUNCTIONS(Examples)
};

QString gasText()
{
    return ExampleText::tr(
        "A thousand equal circles start with the same speed, 2 m/s, in all directions. Press Run "
        "and watch the speeds at the bottom right.\n\n"
        "No hit is aimed at anything, yet within a second or two the speeds spread until they lie "
        "along one curve, that of Maxwell and Boltzmann. No energy is lost: only how the circles "
        "share it changes.\n\n"
        "- Go back on the timeline: the curve is the same all the time, as it depends on the mean "
        "energy alone.\n"
        "- Set the restitution to 0.99: the gas cools, and the curve moves to the left.\n"
        "- The colours say which half a circle comes from. They mix much more slowly than the "
        "speeds.");
}

QString pistonText()
{
    return ExampleText::tr(
        "A heavy circle falls onto a bed of 124 light ones, each of which has a six-thousandth of "
        "its mass. Press Run and watch the energy.\n\n"
        "A hit with e = 0.9 leaves e² = 81 % of the energy of the motion towards each other. Yet "
        "here a fifth of all energy goes in less than a tenth of a second, most of it in two "
        "blows, "
        "at 0.94 s and 0.99 s: light circles that are caught between the heavy one and the floor "
        "are hit to and fro ever faster, hundreds of times in a hundredth of a second. That is how "
        "an inelastic collapse begins.\n\n"
        "- Go back on the timeline to the blows, and step through them with → and ←.\n"
        "- Set the restitution to 1: the bed becomes a gas under a piston, and throws it back.");
}

} // namespace

QString idOf(Example example)
{
    switch (example) {
    case Example::Gas:
        return QStringLiteral("gas");
    case Example::PistonDrop:
        break;
    }
    return QStringLiteral("piston-drop");
}

std::optional<Example> exampleFromId(const QString &id)
{
    const auto *found = std::find_if(std::begin(allExamples), std::end(allExamples),
                                     [&id](Example example) { return idOf(example) == id; });
    return found != std::end(allExamples) ? std::optional(*found) : std::nullopt;
}

QString fileOf(Example example)
{
    return QStringLiteral(":/examples/%1.json").arg(idOf(example));
}

QString titleOf(Example example)
{
    switch (example) {
    case Example::Gas:
        return ExampleText::tr("Gas");
    case Example::PistonDrop:
        break;
    }
    return ExampleText::tr("Piston drop");
}

QString textOf(Example example)
{
    const QString back = ExampleText::tr(
        "This scene belongs to no step. Choose a step above to go back to the lab.");
    return (example == Example::Gas ? gasText() : pistonText()) + QStringLiteral("\n\n") + back;
}

bool showsSpeeds(Example example)
{
    return example == Example::Gas;
}

} // namespace cradle
