// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_lengths.h"

#include "tasks/judging/wall_comparison.h"

#include <algorithm>

namespace cradle {

std::vector<WallLength> wallLengths()
{
    const auto fixed = [](double length) { return [length](const WallHit &) { return length; }; };
    return {{fixed(0.0), WallText::tr("At the %walls the centre of %who is asked for, not the rim"),
             WallText::tr("Circle %3 is turned only when its centre is past the wall, with its rim "
                          "one radius, %1 m, outside. A wall meets a body where the body ends.")},
            {[](const WallHit &hit) { return hit.otherRadius; },
             WallText::tr("At the %walls the radius of another circle stands for that of %who"),
             WallText::tr("The radius of circle %3 is %1 m, and it turns when its centre is %2 m "
                          "from the wall: "
                          "the radius of the other circle there. Look at whose radius "
                          "stands in the questions.")},
            {[](const WallHit &hit) { return std::max(hit.radius, hit.otherRadius); },
             WallText::tr("At the %walls the larger radius stands for that of %who"),
             WallText::tr("The radius of circle %3 is %1 m, and it turns when its centre is %2 m "
                          "from the wall: the radius of the other circle there, which is "
                          "larger. Each circle has its own.")},
            {[](const WallHit &hit) { return std::min(hit.radius, hit.otherRadius); },
             WallText::tr("At the %walls the smaller radius stands for that of %who"),
             WallText::tr("The radius of circle %3 is %1 m, and it turns when its centre is %2 m "
                          "from the wall: the radius of the other circle there, which is "
                          "smaller. Each circle has its own.")},
            {[](const WallHit &hit) { return 0.5 * hit.radius; },
             WallText::tr("Hits at the %walls turn %who round too late"),
             WallText::tr("The radius of circle %3 is %1 m, and it turns when its centre is %2 m "
                          "from the wall: "
                          "half of that. From the centre to the rim it is the whole radius.")},
            {fixed(0.2), WallText::tr("At the %walls a number stands for the radius of %who"),
             WallText::tr("Here the radius of circle %3 is %1 m, and yet it turns when "
                          "its centre is "
                          "0.2 m from the wall. Take the radius that the circle has.")},
            {[](const WallHit &hit) { return 2.0 * hit.radius; },
             WallText::tr("Hits at the %walls turn %who round too early"),
             WallText::tr("The radius of circle %3 is %1 m, and it turns when its centre is %2 m "
                          "from the wall: "
                          "twice the radius. From the centre to the rim it is one.")},
            {[](const WallHit &hit) { return -hit.radius; },
             WallText::tr("Hits at the %walls turn %who round at the far side of the rim"),
             WallText::tr(
                 "Circle %3 turns when its centre is one radius, %1 m, past the wall. Of its two "
                 "ends the near one touches first: look at the sign in front of the "
                 "radius.")}};
}

} // namespace cradle
