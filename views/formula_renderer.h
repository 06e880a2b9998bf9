// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QHash>
#include <QObject>
#include <QSet>
#include <QString>
#include <QThread>
#include <QTimer>

#include <utility>

namespace cradle {

class FormulaWorker;

/// A typeset formula, or the reason why there is none. Lengths are in ex: 1 ex is the height of
/// an x, so a caller multiplies by the x-height of the font around the formula.
struct Formula {
    enum class State {
        Ready,      ///< `svg` and the lengths hold
        Broken,     ///< the TeX is wrong: `error` tells how
        Unavailable ///< built without MathJax, or it cannot run: `error` tells which
    };

    State state = State::Unavailable;
    QByteArray svg;      ///< one complete picture, drawn in `currentColor`
    double width = 0.0;  ///< ex, > 0
    double height = 0.0; ///< ex, > 0, from the lowest to the highest point
    double depth = 0.0;  ///< ex, the part of `height` below the baseline; may be negative
    QString error;

    friend bool operator==(const Formula &, const Formula &) = default;
};

/// Typesets TeX formulas as SVG on a thread of its own.
///
/// MathJax, which takes some 40 MB, is loaded on the first formula that is in neither cache, and
/// goes when none has been asked for a while. Formulas are kept in memory and, across runs, in the
/// cache folder.
class FormulaRenderer final : public QObject
{
    Q_OBJECT
public:
    /// \param cacheFolder  created as needed; empty: "formulas" in the user's cache folder
    explicit FormulaRenderer(QObject *parent = nullptr, const QString &cacheFolder = {});

    /// Stops a formula that is being typeset and waits for the thread.
    ~FormulaRenderer() override;

    /// Asks for `ready`, which always comes later, never from within this call, and once for
    /// requests of the same formula that are made before it.
    void request(const QString &tex, bool display);

    /// The answer of an earlier request, or nullptr; valid until the next one.
    [[nodiscard]] const Formula *known(const QString &tex, bool display) const;

    /// Whether no formula is being waited for.
    [[nodiscard]] bool isIdle() const { return m_waiting.isEmpty(); }
    /// Whether MathJax is in memory.
    [[nodiscard]] bool isLoaded() const;

signals:
    void ready(const QString &tex, bool display, const cradle::Formula &formula);

private:
    using Key = std::pair<QString, bool>;

    void finish(const Key &key, const Formula &formula);
    void unload();

    QTimer m_rest; ///< since the last formula that was waited for
    QThread m_thread;
    FormulaWorker *m_worker; ///< lives in m_thread, which deletes it
    QHash<Key, Formula> m_known;
    QSet<Key> m_waiting;
};

} // namespace cradle
