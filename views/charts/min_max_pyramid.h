// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>

#include <deque>
#include <vector>

namespace cradle {

/// A growing curve of (time, value) samples with a hierarchy of its extremes, so that any range
/// of it is drawn at a cost of the pixel columns and not of the samples: O(columns · log samples).
/// Samples in a row with the same value are kept as the two ends of the level line.
class MinMaxPyramid
{
public:
    /// Appends a sample; \p time must not be earlier than the last one. Two samples at one time
    /// are an upright step. A value that is not finite is left out.
    void append(double time, double value);
    void clear();
    /// Forgets the samples before \p time; a level line that crosses it starts there.
    void dropBefore(double time);

    [[nodiscard]] bool isEmpty() const { return m_samples.empty(); }
    [[nodiscard]] double firstTime() const { return m_samples.front().x(); }
    [[nodiscard]] double lastTime() const { return m_samples.back().x(); }
    [[nodiscard]] double lastValue() const { return m_samples.back().y(); }

    /// The value of the last sample at or before \p time; the first one's if all are later, 0 if
    /// there is none.
    [[nodiscard]] double valueAt(double time) const;
    /// The least and the greatest value from \p t0 to \p t1, with the neighbour beyond each end;
    /// zeros if there is no sample.
    [[nodiscard]] std::pair<double, double> bounds(double t0, double t1) const;
    [[nodiscard]] double minimum() const; ///< of all samples; 0 if there is none
    [[nodiscard]] double maximum() const; ///< of all samples; 0 if there is none

    /// The curve from \p t0 to \p t1 in order of time, with the neighbour beyond each end: all
    /// samples if they are no more than two to a column, else the least and the greatest of each
    /// column. Columns start at multiples of (t1 − t0)/columns, so that a window that slides
    /// keeps its picture.
    /// \return at most 2 (columns + 2) points
    [[nodiscard]] QList<QPointF> decimate(double t0, double t1, int columns) const;

    /// The points of a window, from one time to the next: the columns that lie behind the newest
    /// sample stay as they are while the window does.
    class Window
    {
    public:
        [[nodiscard]] const QList<QPointF> &points() const { return m_points; }

    private:
        friend class MinMaxPyramid;
        quint64 m_stamp = 0; ///< of the samples, when the points were made
        double m_t0 = 0.0;   ///< s
        double m_t1 = 0.0;   ///< s
        int m_columns = 0;
        QList<QPointF> m_points;
        qsizetype m_settled = 0; ///< points that stay
        qint64 m_next = 0;       ///< the first sample after them
    };
    /// Makes the points of decimate() in \p window, at the cost of what is new since they were made
    /// there for the same times and columns.
    void decimate(Window &window, double t0, double t1, int columns) const;

    [[nodiscard]] qint64 bytes() const; ///< memory held

private:
    /// Indices of the least and the greatest sample of a range.
    struct Extremes {
        qint64 least = 0;
        qint64 greatest = 0;
    };
    /// Extremes of groups of groupSize^(level + 1) samples; complete groups only.
    struct Level {
        std::deque<Extremes> groups;
        qint64 first = 0; ///< number of the first group kept
    };
    static constexpr qint64 groupSize = 8;

    [[nodiscard]] const QPointF &sample(qint64 index) const
    {
        return m_samples[static_cast<std::size_t>(index - m_first)];
    }
    [[nodiscard]] qint64 end() const { return m_first + static_cast<qint64>(m_samples.size()); }
    [[nodiscard]] qint64 firstNotBefore(double time, qint64 from) const;
    [[nodiscard]] qint64 firstAfter(double time, qint64 from) const;
    template <class IsBefore>
    [[nodiscard]] qint64 firstNot(IsBefore isBefore, qint64 from, qint64 to) const;
    /// \param levels  how many of the levels may be used
    [[nodiscard]] Extremes extremes(qint64 from, qint64 to, std::size_t levels) const;
    [[nodiscard]] Extremes extremes(qint64 from, qint64 to) const
    {
        return extremes(from, to, m_levels.size());
    }
    void join(Extremes &sum, const Extremes &part) const;
    void closeGroups();
    [[nodiscard]] static quint64 newStamp();

    std::deque<QPointF> m_samples;
    qint64 m_first = 0; ///< index of the first sample kept
    std::vector<Level> m_levels;
    /// Another one wherever samples do not just follow those that were there.
    quint64 m_stamp = newStamp();
};

} // namespace cradle
