// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/plot_curves.h"

#include "views/theme.h"

#include <algorithm>
#include <array>

namespace cradle {

void PlotCurves::clear()
{
    m_curves.clear();
    m_marks.clear();
}

void PlotCurves::update(const ProgramNotes &notes)
{
    const auto &plotted = notes.curves();
    for (std::size_t i = 0; i < plotted.size(); ++i) {
        const ProgramNotes::Curve &from = plotted[i];
        if (i == m_curves.size()) {
            m_curves.push_back({from.name, {}});
            m_marks.emplace_back();
        }
        Mark &mark = m_marks[i];
        // A long curve was thinned out meanwhile: its points have other numbers now.
        const bool isThinner = mark.count > from.times.size()
                               || (mark.count > 0 && from.times[mark.count - 1] != mark.time);
        if (isThinner) {
            m_curves[i].samples.clear();
            mark = {};
        }
        for (; mark.count < from.times.size(); ++mark.count) {
            mark.time = from.times[mark.count];
            m_curves[i].samples.append(mark.time, from.values[mark.count]);
        }
    }
}

QColor plotColour(int index)
{
    static constexpr std::array<QRgb, 6> onLight{0x0b7285, 0x862e9c, 0x5c7a00,
                                                 0xa0460f, 0x3b44a8, 0xad1a6b};
    static constexpr std::array<QRgb, 6> onDark{0x3bc9db, 0xda77f2, 0xa9d63a,
                                                0xffa06b, 0x9fa8ff, 0xff7ac0};
    const auto i = static_cast<std::size_t>(std::max(index, 0)) % onLight.size();
    return QColor(theme().dark ? onDark[i] : onLight[i]);
}

} // namespace cradle
