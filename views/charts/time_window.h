// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace cradle {

/// Which part of the run the charts show; all charts of a window share one.
class TimeWindow final : public QObject
{
    Q_OBJECT
public:
    enum class Kind {
        LastSeconds, ///< so many seconds around the moment shown
        All,         ///< the whole run
        Zoomed       ///< what the student has zoomed to
    };
    static constexpr double lastSeconds = 10.0;
    static constexpr double narrowest = 1e-3; ///< s

    /// From left to right, s.
    struct Span {
        double from = 0.0;
        double to = 1.0;

        [[nodiscard]] double length() const { return to - from; }
        friend bool operator==(const Span &, const Span &) = default;
    };

    using QObject::QObject;

    [[nodiscard]] Kind kind() const { return m_kind; }
    /// Shows LastSeconds or All, and ends a zoom.
    void show(Kind kind);
    /// Shows \p span of a run whose charts show \p whole without a zoom; if it is no less than
    /// that, the whole.
    void zoomTo(Span span, Span whole);
    /// Shows \p factor times as much of \p shown, where the moment \p about keeps its place.
    void zoomBy(double factor, double about, Span shown, Span whole);
    /// Moves \p shown by \p seconds, as far as \p whole reaches.
    void panBy(double seconds, Span shown, Span whole);
    /// Back to what was shown before the zoom.
    void reset();
    /// While the mouse is held in a chart its window does not run away under it.
    void setHeld(bool held) { m_held = held; }

    /// What is shown of a run that is kept over \p run, at the moment \p shown (s), where there are
    /// curves to \p end. A zoomed window follows that moment where it leaves the window, not where
    /// it was outside.
    [[nodiscard]] Span choose(Span run, double end, double shown);
    /// What Kind::All shows of curves from \p first to \p end, s.
    [[nodiscard]] static Span whole(double first, double end);

signals:
    void changed();

private:
    [[nodiscard]] Span lastOf(Span run, double shown);

    Kind m_kind = Kind::All;
    Kind m_before = Kind::All; ///< the zoom
    Span m_zoom;
    double m_lastStart = 0.0; ///< of Kind::LastSeconds, s
    double m_shown = 0.0;     ///< s, when it was last chosen
    bool m_held = false;
};

} // namespace cradle
