// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QElapsedTimer>
#include <QWidget>

#include <vector>

QT_BEGIN_NAMESPACE
class QAction;
class QLabel;
class QTableView;
class QTabWidget;
QT_END_NAMESPACE

namespace cradle {

class FrameThrottle;
class HitsModel;
class ValuesTab;

/// Tables of the moment shown: the numbers of every circle, and the hits so far.
class ValuesPane final : public QWidget
{
    Q_OBJECT
public:
    explicit ValuesPane(const Simulation &simulation, QWidget *parent = nullptr);

    /// Adds \p widget as one more tab (the console). The title follows the widget's window title
    /// when that changes, with the language.
    void addTab(QWidget *widget, const QString &title);
    void setTabTitle(QWidget *widget, const QString &title);
    /// Puts a mark behind the title of the tab of \p widget, if that is not the one shown: there is
    /// something to see. It goes when the tab is shown, or with \p marked false.
    void markTab(QWidget *widget, bool marked);
    /// For showing one more tab.
    [[nodiscard]] QTabWidget &tabs() { return *m_tabs; }
    [[nodiscard]] QString hitSentence() const;
    [[nodiscard]] QSize sizeHint() const override { return {344, 240}; }

public slots:
    void copySelection(); ///< of the table shown, as text with tabs
    void copyAll();       ///< with the headers

signals:
    void seekRequested(qint64 index); ///< a hit was chosen: the frame where it shows

protected:
    void changeEvent(QEvent *event) override;

private:
    /// A tab that was added.
    struct Tab {
        QWidget *widget;
        QString title;
        bool marked = false;
    };

    void showTab(int index);
    void showTitle(const Tab &tab);
    void refresh();
    void refreshHits();
    void fitColumns(); ///< of both tables
    void retranslate();
    void seekHit(const QModelIndex &index);
    [[nodiscard]] QTableView *shownTable() const;

    const Simulation &m_simulation;
    HitsModel *m_hitsModel;
    QTabWidget *m_tabs;
    ValuesTab *m_values;
    QTableView *m_hits;
    QLabel *m_noHits; ///< in place of an empty list
    QAction *m_copyAction;
    QAction *m_copyAllAction;
    FrameThrottle *m_throttle;
    std::vector<Tab> m_added;
    QElapsedTimer m_sinceTitle; ///< the tab of the hits got its title
    int m_fittedHits =
        -1; ///< rows to whose texts the columns were fitted; −1: not even to the titles
};

} // namespace cradle
