// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QTableView;
QT_END_NAMESPACE

namespace cradle {

class SentenceLabel;
class ValuesModel;

/// The numbers of every circle at the moment shown, and below them in words the last hit and how
/// far the run is from the exact motion.
class ValuesTab final : public QWidget
{
    Q_OBJECT
public:
    explicit ValuesTab(const Simulation &simulation, QWidget *parent = nullptr);

    void refresh(); ///< the moment, or the run, is another
    void reload();  ///< numbers look otherwise: the language or the font is another
    void fit();     ///< columns, rows and sentences into the room that there is
    void retranslate();
    [[nodiscard]] QTableView *table() { return m_table; }
    [[nodiscard]] QString hitSentence() const;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fitHeights();
    void fitSentences();

    const Simulation &m_simulation;
    ValuesModel *m_model;
    QTableView *m_table;
    SentenceLabel *m_sentence;
    SentenceLabel *m_exact; ///< below it
};

} // namespace cradle
