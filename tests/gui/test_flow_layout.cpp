// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/flow_layout.h"

#include <QTest>
#include <QWidget>

using namespace cradle;

/// Controls that stand as words in a text.
class TestFlowLayout final : public QObject
{
    Q_OBJECT
private slots:
    void keepsItsMargins_data();
    void keepsItsMargins();
};

void TestFlowLayout::keepsItsMargins_data()
{
    QTest::addColumn<Qt::LayoutDirection>("direction");
    QTest::addColumn<int>("x"); // of the first control, px
    QTest::newRow("left to right") << Qt::LeftToRight << 12;
    QTest::newRow("right to left") << Qt::RightToLeft << 132 - 14 - 50;
}

/// Two fit into the first row, the third stands under the first.
void TestFlowLayout::keepsItsMargins()
{
    QFETCH(Qt::LayoutDirection, direction);
    QFETCH(int, x);
    QWidget window;
    window.setLayoutDirection(direction);
    auto *flow = new FlowLayout;
    window.setLayout(flow);
    flow->setSpacing(6);
    flow->setContentsMargins(12, 8, 14, 9);
    QWidget *controls[3]{};
    for (QWidget *&control : controls) {
        control = new QWidget;
        control->setFixedSize(50, 20);
        flow->addWidget(control);
    }
    QCOMPARE(flow->sizeHint(), QSize(12 + 3 * 50 + 2 * 6 + 14, 8 + 20 + 9));
    QCOMPARE(flow->minimumSize(), QSize(12 + 50 + 14, 8 + 20 + 9));
    QCOMPARE(flow->heightForWidth(132), 8 + 20 + 6 + 20 + 9);
    QCOMPARE(flow->heightForWidth(131), 8 + 3 * 20 + 2 * 6 + 9);
    flow->setGeometry({0, 0, 132, 63});
    QCOMPARE(controls[0]->pos(), QPoint(x, 8));
    QCOMPARE(controls[2]->pos(), QPoint(x, 8 + 20 + 6));
}

QTEST_MAIN(TestFlowLayout)
#include "test_flow_layout.moc"
